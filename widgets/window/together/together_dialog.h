// Plans the work of several machines in one cell: places them, finds an order of work in which they
// do not meet, shows all moving in one time and saves their programs with marks.
#pragma once

#include "document/joining.h"
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
  // The project shown is the first machine. Closing the dialog cancels. Precondition: the job has a
  // motion.
  TogetherDialog(const QString& name, std::shared_ptr<const project::Job> job,
                 QWidget* parent = nullptr);
  ~TogetherDialog() override;

  const JoinedMachines& machines() const { return *machines_; }

public slots:
  // Adds a project from a file, opposite the first machine.
  void addFile(const QString& file);
  // Adds the first machine's job once more.
  void addAgain();
  void findOrder();
  void setTimeS(double timeS);
  // Writes all outputs into the folder; a message appears in the dialog.
  void save(const QString& folder);

private:
  QWidget* buildSide();
  QWidget* buildTimeline();
  void listen();
  void add(const QString& name, const std::shared_ptr<const project::Job>& job);
  void askForFile();
  void askForFolder();
  void removeChosen();
  void showMachines();
  void showResult();
  void listPlaces();
  void goTo(const QListWidgetItem* item);
  void conclude(const QString& text, bool good);
  void refresh();

  JoinedMachines* machines_;
  document::Joining joining_;
  MachineTable* table_ = nullptr;
  QPushButton *addFile_ = nullptr, *addAgain_ = nullptr, *remove_ = nullptr, *find_ = nullptr,
              *cancel_ = nullptr, *save_ = nullptr;
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
