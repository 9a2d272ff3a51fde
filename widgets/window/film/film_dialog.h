// Saves a film of the robot that prints the plan.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/plan_result.h"

#include <QDialog>
#include <memory>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace voluta::window {

class FilmDialog : public QDialog {
  Q_OBJECT

public:
  // `plan`: with its motion. Deletes itself when closed; a film that is not finished is left out.
  FilmDialog(std::shared_ptr<const pipeline::PlanResult> plan, const QString& name, bool dark,
             QWidget* parent);

signals:
  void saved(const QString& file);

private:
  void choose();
  void save(const QString& file);
  void showError(const QString& message);

  std::shared_ptr<const pipeline::PlanResult> plan_;
  QString name_;
  bool dark_;
  jobs::JobRunner runner_;
  QSpinBox* length_;
  QComboBox *size_, *view_;
  QProgressBar* progress_;
  QLabel* message_;
  QPushButton* save_;
};

} // namespace voluta::window
