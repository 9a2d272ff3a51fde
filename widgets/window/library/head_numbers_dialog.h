// A head from a few numbers: a conical nozzle below a square block.
#pragma once

#include "process/head_shapes.h"

#include <QDialog>
#include <optional>

class QLabel;
class QPushButton;

namespace voluta::panels {
class HeadDrawing;
}

namespace voluta::window {

class HeadNumbersDialog : public QDialog {
  Q_OBJECT

public:
  // `process`: drawn with the new head.
  HeadNumbersDialog(const process::Process& process, QWidget* parent);

  // Of the numbers; none while they contradict each other.
  const std::optional<process::HeadShape>& head() const { return head_; }

private:
  void evaluate();

  process::Process process_;
  process::HeadNumbers numbers_;
  std::optional<process::HeadShape> head_;
  panels::HeadDrawing* drawing_;
  QLabel *sign_, *problem_;
  QPushButton* use_;
};

} // namespace voluta::window
