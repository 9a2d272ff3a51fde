// Corrections of a process's sizes from a measured accuracy plate.
#pragma once

#include "process/measured_sizes.h"

#include <QDialog>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::window {

class SizesDialog : public QDialog {
  Q_OBJECT

public:
  // `process`: the one that the plate was printed with.
  SizesDialog(const process::Process& process, QWidget* parent);

  // With the new corrections; none while the sizes give none.
  const std::optional<process::Process>& corrected() const { return corrected_; }

private:
  void choosePlate();
  void evaluate();

  process::Process process_;
  std::vector<process::MeasuredSize> sizes_;
  std::optional<process::Process> corrected_;
  QComboBox* plate_;
  std::vector<QLabel*> nominal_;
  std::vector<forms::NumberBox*> measured_;
  QLabel *sign_, *found_;
  QPushButton* use_;
};

} // namespace voluta::window
