#include "timeline/chart_canvas.h"

#include <QChart>
#include <QLegend>
#include <QMouseEvent>
#include <QPainter>
#include <QValueAxis>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace voluta::timeline {

namespace {
constexpr double kClickPx = 3.0; // a press that moves no further is a click
constexpr double kZoomPerNotch = 1.25;
constexpr double kLeastSpanS = 0.01;
constexpr double kSmoothedSwings = 8.0; // way up and down, in widths of the chart

// A step of 1, 2 or 5 times a power of ten that divides `span` into at most `most` parts.
double niceStep(double span, int most) {
  const double rough = span / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough)
      return factor * power;
  return 10.0 * power;
}

// The axis makes an item a tick whenever either changes, so its ticks must never be too close for
// the range that it has in between.
void setRange(QValueAxis* axis, double low, double high, int ticks) {
  const double step = niceStep(high - low, ticks);
  axis->setTickInterval(std::max(axis->tickInterval(), step));
  axis->setRange(low, high);
  axis->setTickInterval(step);
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step))), 0, 6);
  axis->setLabelFormat(QStringLiteral("%.%1f").arg(decimals));
}
} // namespace

ChartCanvas::ChartCanvas(QWidget* parent)
    : QWidget(parent), chart_(new QChart), time_(new QValueAxis(this)),
      value_(new QValueAxis(this)) {
  scene_.addItem(chart_);
  chart_->legend()->hide();
  chart_->setBackgroundRoundness(0.0);
  chart_->setAnimationOptions(QChart::NoAnimation);
  for (QValueAxis* axis : {time_, value_}) {
    axis->setTickAnchor(0.0);
    axis->setTickInterval(1.0);
    axis->setTickType(QValueAxis::TicksDynamic);
  }
  chart_->addAxis(time_, Qt::AlignBottom);
  chart_->addAxis(value_, Qt::AlignLeft);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAttribute(Qt::WA_OpaquePaintEvent);
  applyPalette();
}

ChartCanvas::~ChartCanvas() {
  // The axes are this widget's children and the chart's members: the chart goes first.
  chart_->removeAxis(time_);
  chart_->removeAxis(value_);
  delete time_;
  delete value_;
}

QSize ChartCanvas::sizeHint() const {
  return {480, 160};
}

QSize ChartCanvas::minimumSizeHint() const {
  return {160, 90};
}

void ChartCanvas::setAxisTitle(const QString& title) {
  value_->setTitleText(title);
  setAccessibleName(title);
  stale_ = true;
  update();
}

void ChartCanvas::setTimeTitle(const QString& title) {
  time_->setTitleText(title);
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
  toS_ = std::max(toS, fromS + kLeastSpanS);
  low_ = low;
  high_ = high;
  setRange(time_, fromS_, toS_, std::max(2, width() / 90));
  setRange(value_, low, high, std::max(2, height() / 35));
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

// Set by hand: the chart would lay itself out only once the event loop came round.
QRectF ChartCanvas::plotArea() const {
  const QFontMetrics metrics(font());
  const double left = metrics.horizontalAdvance(QStringLiteral("-0000.0")) + 1.6 * metrics.height();
  const double bottom = 3.4 * metrics.height();
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

void ChartCanvas::applyPalette() {
  const QColor text = palette().color(QPalette::WindowText);
  QColor grid = text;
  grid.setAlphaF(0.15f);
  chart_->setBackgroundBrush(palette().color(QPalette::Base));
  for (QValueAxis* axis : {time_, value_}) {
    axis->setLabelsColor(text);
    axis->setTitleBrush(text);
    axis->setLabelsFont(font());
    axis->setTitleFont(font());
    axis->setLinePenColor(grid);
    axis->setGridLineColor(grid);
  }
  stale_ = true;
  update();
}

void ChartCanvas::drawPicture() {
  chart_->resize(size());
  chart_->setPlotArea(plotArea());
  scene_.setSceneRect(QRectF(QPointF(), size()));
  picture_ = QPixmap(size() * devicePixelRatioF());
  picture_.setDevicePixelRatio(devicePixelRatioF());
  picture_.fill(palette().color(QPalette::Base));
  QPainter painter(&picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  scene_.render(&painter, QRectF(QPointF(), size()), scene_.sceneRect());
  drawCurves(painter);
  stale_ = false;
}

// The chart draws axes and grid. Its own series take ten times as long for as many points: they
// prepare for being clicked.
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
    // Segment by segment: stroking a polyline of thousands of points in one takes twenty times as
    // long. Smoothing costs by the length: curves that swing up and down within a few columns
    // fill them, and are drawn without.
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
      event->type() == QEvent::StyleChange)
    applyPalette();
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
