#include "window/progress_line.h"

#include <QStyleOptionProgressBar>
#include <QStylePainter>
#include <algorithm>
#include <cmath>

namespace voluta::window {

namespace {
constexpr int kWidth = 180, kSteps = 1000;
}

ProgressLine::ProgressLine(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ProgressLine::setFraction(double fraction) {
  fraction_ = std::clamp(fraction, 0.0, 1.0);
  update();
}

QSize ProgressLine::sizeHint() const {
  return {kWidth, fontMetrics().height() + 6};
}

void ProgressLine::paintEvent(QPaintEvent*) {
  QStyleOptionProgressBar option;
  option.initFrom(this);
  option.state |= QStyle::State_Horizontal;
  option.maximum = kSteps;
  option.progress = static_cast<int>(std::lround(kSteps * fraction_));
  option.text = QString("%1 %").arg(static_cast<int>(100.0 * fraction_));
  option.textAlignment = Qt::AlignCenter;
  option.textVisible = true;
  QStylePainter(this).drawControl(QStyle::CE_ProgressBar, option);
}

} // namespace voluta::window
