// A progress bar that repaints with the next frame. QProgressBar repaints the whole window at once
// whenever its value changes.
#pragma once

#include <QWidget>

namespace voluta::window {

class ProgressLine : public QWidget {
  Q_OBJECT

public:
  explicit ProgressLine(QWidget* parent = nullptr);

  // In [0, 1].
  void setFraction(double fraction);
  double fraction() const { return fraction_; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  double fraction_ = 0.0;
};

} // namespace voluta::window
