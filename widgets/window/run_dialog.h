// Compares a recorded run with the plan and lists where it differs most.
#pragma once

#include "document/run_comparing.h"
#include "forms/icons.h"

#include <QDialog>
#include <QString>
#include <vector>

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QProgressBar;

namespace voluta::window {

class RunDialog : public QDialog {
  Q_OBJECT

public:
  // Starts at once; closing the dialog cancels. Precondition: the plan has a motion.
  RunDialog(const QString& record, std::shared_ptr<const pipeline::PlanResult> plan,
            QWidget* parent = nullptr);

signals:
  // All places, once the run is compared.
  void compared(const std::vector<voluta::record::ErrorPlace>& places);
  // A click on a place: its point of the trajectory.
  void placeChosen(std::size_t point);

private:
  void show(const pipeline::ComparedRun& run);
  void conclude(const QString& text, forms::Icon sign);
  void list(const std::vector<record::ErrorPlace>& places);

  document::RunComparing comparing_;
  QLabel *sign_, *figures_;
  QProgressBar* progress_;
  QLabel* placesTitle_;
  QListWidget* places_;
  QDialogButtonBox* buttons_;
};

// Returns e.g. "Speed -2.0 % over 10 mm", in the window's language.
QString placeText(const record::ErrorPlace& place);

} // namespace voluta::window
