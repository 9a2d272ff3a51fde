#include "timeline/chart_canvas.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace voluta::timeline {

namespace {
constexpr double kClickPx = 3.0; // a press that moves less is a click
constexpr double kZoomPerNotch = 1.25;
constexpr double kMinSpanS = 0.01;
constexpr double kSmoothedSwings = 8.0; // total up-and-down length, in chart widths

// Returns a step of 1, 2 or 5 times a power of ten that divides `span` into at most `maxTicks`
// parts.
double niceStep(double span, int maxTicks) {
  const double rough = span / std::max(1, maxTicks);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough)
      return factor * power;
  return 10.0 * power;
}

int decimalsOf(double step) {
  return std::clamp(static_cast<int>(-std::floor(std::log10(step))), 0, 6);
}
} // namespace

ChartCanvas::ChartCanvas(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

QSize ChartCanvas::sizeHint() const {
  return {480, 160};
}

QSize ChartCanvas::minimumSizeHint() const {
  return {140, 90};
}

void ChartCanvas::setAxisTitle(const QString& title) {
  valueTitle_ = title;
  setAccessibleName(title);
  stale_ = true;
  update();
}

void ChartCanvas::setTimeTitle(const QString& title) {
  timeTitle_ = title;
  stale_ = true;
  update();
}

void ChartCanvas::setHint(const QString& hint) {
  hint_ = hint;
  update();
}

void ChartCanvas::setContent(std::vector<ChartCurve> curves, double fromS, double toS, double low,
                             double high) {
  curves_ = std::move(curves);
  fromS_ = fromS;
  toS_ = std::max(toS, fromS + kMinSpanS);
  low_ = low;
  high_ = high;
  stale_ = true;
  update();
}

void ChartCanvas::setTimeS(double timeS) {
  const auto strip = [this] {
    return QRectF(xOf(timeS_) - 3.0, 0.0, 6.0, height()).toAlignedRect();
  };
  const QRect before = strip();
  timeS_ = timeS;
  update(before);
  update(strip());
}

int ChartCanvas::columns() const {
  return std::max(1, static_cast<int>(plotArea().width() * devicePixelRatioF()));
}

QRectF ChartCanvas::plotArea() const {
  const QFontMetrics metrics(font());
  const double left = metrics.horizontalAdvance(QStringLiteral("-0000.0")) + 1.6 * metrics.height();
  const double bottom = 2.0 * metrics.height() + 10.0;
  const double top = 0.7 * metrics.height();
  return {left, top, std::max(1.0, width() - left - 14.0), std::max(1.0, height() - top - bottom)};
}

double ChartCanvas::xOf(double timeS) const {
  const QRectF area = plotArea();
  return area.left() + (timeS - fromS_) / (toS_ - fromS_) * area.width();
}

double ChartCanvas::timeAt(double x) const {
  const QRectF area = plotArea();
  return fromS_ + (x - area.left()) / area.width() * (toS_ - fromS_);
}

void ChartCanvas::drawPicture() {
  picture_ = QPixmap(size() * devicePixelRatioF());
  picture_.setDevicePixelRatio(devicePixelRatioF());
  picture_.fill(palette().color(QPalette::Base));
  QPainter painter(&picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  drawAxes(painter);
  drawCurves(painter);
  stale_ = false;
}

void ChartCanvas::drawAxes(QPainter& painter) const {
  const QRectF area = plotArea();
  const QFontMetricsF metrics(font());
  const QColor text = palette().color(QPalette::WindowText);
  QColor grid = text;
  grid.setAlphaF(0.15f);
  const QLocale locale;
  const auto eachTick = [](double low, double high, int maxTicks, const auto& draw) {
    const double step = niceStep(high - low, maxTicks);
    const auto first = static_cast<long long>(std::ceil(low / step - 1e-9));
    const auto last = static_cast<long long>(std::floor(high / step + 1e-9));
    for (long long i = first; i <= last; ++i)
      draw(static_cast<double>(i) * step, decimalsOf(step));
  };
  const double row = metrics.height();
  eachTick(low_, high_, std::max(2, height() / 35), [&](double value, int decimals) {
    const double y = area.bottom() - (value - low_) / (high_ - low_) * area.height();
    painter.setPen(grid);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(text);
    painter.drawText(QRectF(0.0, y - row, area.left() - 5.0, 2.0 * row),
                     Qt::AlignRight | Qt::AlignVCenter, locale.toString(value, 'f', decimals));
  });
  eachTick(fromS_, toS_, std::max(2, width() / 90), [&](double seconds, int decimals) {
    const double x = xOf(seconds);
    painter.setPen(grid);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(text);
    const QString label = locale.toString(seconds, 'f', decimals);
    const double half = 0.5 * metrics.horizontalAdvance(label) + 1.0;
    const double middle = std::clamp(x, half, std::max(half, width() - half));
    painter.drawText(QRectF(middle - half, area.bottom() + 3.0, 2.0 * half, row), Qt::AlignCenter,
                     label);
  });
  painter.setPen(text);
  painter.drawText(QRectF(area.left(), area.bottom() + 3.0 + row, area.width(), row),
                   Qt::AlignCenter, timeTitle_);
  painter.save();
  painter.translate(0.0, area.center().y());
  painter.rotate(-90.0);
  painter.drawText(QRectF(-0.5 * height(), 2.0, height(), row), Qt::AlignCenter, valueTitle_);
  painter.restore();
}

void ChartCanvas::drawCurves(QPainter& painter) const {
  const QRectF area = plotArea();
  painter.setClipRect(area.adjusted(-1.0, -1.0, 1.0, 1.0));
  const double perUnit = area.height() / (high_ - low_);
  const auto yOf = [&](double value) { return area.bottom() - (value - low_) * perUnit; };
  for (const ChartCurve& curve : curves_) {
    painter.setPen(QPen(curve.colour, 1.0, Qt::DashLine));
    for (const std::optional<double>& limit : {curve.low, curve.high})
      if (limit)
        painter.drawLine(QPointF(area.left(), yOf(*limit)), QPointF(area.right(), yOf(*limit)));
  }
  for (const ChartCurve& curve : curves_) {
    // Draw segment by segment: stroking a polyline of thousands of points at once takes twenty
    // times as long. Antialiasing costs by length, so curves that oscillate within a few columns
    // and fill them anyway are drawn without it.
    double upAndDown = 0.0;
    QList<QLineF> lines;
    lines.reserve(curve.points.size());
    for (qsizetype i = 1; i < curve.points.size(); ++i) {
      lines.append({xOf(curve.points[i - 1].x()), yOf(curve.points[i - 1].y()),
                    xOf(curve.points[i].x()), yOf(curve.points[i].y())});
      upAndDown += std::abs(lines.last().dy());
    }
    const bool crowded = upAndDown > kSmoothedSwings * area.width();
    painter.setRenderHint(QPainter::Antialiasing, !crowded);
    painter.setPen(QPen(curve.colour, crowded ? 0.0 : 1.3));
    painter.drawLines(lines);
  }
}

void ChartCanvas::paintEvent(QPaintEvent* event) {
  if (stale_)
    drawPicture();
  QPainter painter(this);
  const QRect area = event->rect();
  const double ratio = picture_.devicePixelRatio();
  painter.drawPixmap(
      area, picture_,
      QRectF(area.x() * ratio, area.y() * ratio, area.width() * ratio, area.height() * ratio)
          .toRect());
  if (!hint_.isEmpty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(plotArea(), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  const QRectF plot = plotArea();
  const double x = xOf(timeS_);
  if (curves_.empty() || x < plot.left() - 0.5 || x > plot.right() + 0.5)
    return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
}

void ChartCanvas::resizeEvent(QResizeEvent*) {
  stale_ = true;
  emit resized();
}

void ChartCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
      event->type() == QEvent::StyleChange || event->type() == QEvent::LocaleChange) {
    stale_ = true;
    update();
  }
  QWidget::changeEvent(event);
}

void ChartCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  pressedX_ = event->position().x();
  draggedFromS_ = fromS_;
  moved_ = false;
}

void ChartCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (!pressedX_)
    return;
  const double by = event->position().x() - *pressedX_;
  moved_ = moved_ || std::abs(by) > kClickPx;
  if (!moved_)
    return;
  const double span = toS_ - fromS_;
  const double from = draggedFromS_ - by / plotArea().width() * span;
  emit spanWanted(from, from + span);
}

void ChartCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressedX_)
    return;
  pressedX_.reset();
  if (!moved_ && !curves_.empty())
    emit timeClicked(std::clamp(timeAt(event->position().x()), fromS_, toS_));
}

void ChartCanvas::mouseDoubleClickEvent(QMouseEvent*) {
  emit allWanted();
}

void ChartCanvas::wheelEvent(QWheelEvent* event) {
  event->accept();
  const double notches = event->angleDelta().y() / 120.0;
  const double factor = std::pow(kZoomPerNotch, -notches);
  const double about = std::clamp(timeAt(event->position().x()), fromS_, toS_);
  emit spanWanted(about - (about - fromS_) * factor, about + (toS_ - about) * factor);
}

} // namespace voluta::timeline
