// Drawing of a process's head: its profile, and its tip with a bead, both to scale.
#pragma once

#include "process/process.h"

#include <QWidget>

namespace voluta::panels {

class HeadDrawing : public QWidget {
  Q_OBJECT

public:
  explicit HeadDrawing(QWidget* parent = nullptr);

  // Values that cannot be drawn, for example a head without height, leave out their part.
  void setProcess(const process::Process& process);
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void describe();

  process::Process process_;
};

} // namespace voluta::panels
