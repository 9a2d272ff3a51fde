// Replays a program from disk and shows the verdict and the findings by line.
#pragma once

#include "document/verifying.h"
#include "forms/icons.h"

#include <QDialog>
#include <QString>

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QProgressBar;

namespace voluta::panels {
class VerdictTable;
}

namespace voluta::window {

class VerifyDialog : public QDialog {
  Q_OBJECT

public:
  // Starts at once; closing the dialog cancels the replay. Precondition: the plan has a motion.
  VerifyDialog(const QString& program, std::shared_ptr<const pipeline::PlanResult> plan,
               QWidget* parent = nullptr);

private:
  void show(const pipeline::VerifyResult& result);
  void conclude(const QString& verdict, forms::Icon sign);

  document::Verifying verifying_;
  QLabel *sign_, *verdict_;
  QProgressBar* progress_;
  panels::VerdictTable* table_;
  QLabel* foundTitle_;
  QListWidget* found_;
  QDialogButtonBox* buttons_;
};

} // namespace voluta::window
