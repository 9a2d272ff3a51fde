// Plans the work of several machines in one cell: places them, finds an order of work in which they
// do not meet, shows all moving in one time and saves their programs with marks.
#pragma once

#include "document/joining.h"
#include "forms/icons.h"
#include "window/together/joined_machines.h"

#include <QDialog>
#include <QString>
#include <memory>

class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace voluta::timeline {
class MachineLanes;
class Player;
} // namespace voluta::timeline
namespace voluta::viewer {
class MachinesView;
}

namespace voluta::window {

class MachineTable;

class TogetherDialog : public QDialog {
  Q_OBJECT

public:
  // Closing the dialog cancels. Precondition: the jobs have motions; no machines: addFile()
  // follows.
  explicit TogetherDialog(const project::Station& station, QWidget* parent = nullptr);
  ~TogetherDialog() override;

  const JoinedMachines& machines() const { return *machines_; }

public slots:
  // Adds the job of a project, opposite the first machine. The project of a station of several
  // machines takes the place of all.
  void addFile(const QString& file);
  // Adds the first machine's job once more.
  void addAgain();
  void findOrder();
  // Places the machines further apart and looks for an order of work again.
  void moveApart();
  void setTimeS(double timeS);
  // Writes all outputs into the folder; a message appears in the dialog.
  void save(const QString& folder);

private:
  QWidget* buildSide();
  QWidget* buildTimeline();
  void listen();
  void add(project::Machine machine);
  void addOpposite(project::Machine machine);
  void takeStation(const QString& file, const project::Station& station);
  void takeMachines(const project::Station& station);
  void askForFile();
  void askForFolder();
  void removeChosen();
  void showMachines();
  void showResult();
  void listPlaces();
  void goTo(const QListWidgetItem* item);
  void conclude(const QString& text, forms::Icon sign);
  void refresh();

  JoinedMachines* machines_;
  document::Joining joining_;
  MachineTable* table_ = nullptr;
  QPushButton *addFile_ = nullptr, *addAgain_ = nullptr, *remove_ = nullptr, *find_ = nullptr,
              *cancel_ = nullptr, *save_ = nullptr, *apart_ = nullptr;
  QDoubleSpinBox* clearance_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel *sign_ = nullptr, *figures_ = nullptr, *placesTitle_ = nullptr, *time_ = nullptr;
  QListWidget* places_ = nullptr;
  viewer::MachinesView* view_;
  timeline::Player* player_;
  timeline::MachineLanes* lanes_ = nullptr;
  QToolButton* play_ = nullptr;
  QWidget* timeline_ = nullptr;
};

} // namespace voluta::window
