#include "timeline/layer_range_slider.h"

#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace voluta::timeline {

namespace {
constexpr double kHandleHeight = 12.0, kHandleWidth = 18.0;
constexpr double kGrooveWidth = 4.0;
constexpr int kWheelStep = 120; // eighths of a degree per notch
constexpr int kPage = 10;
constexpr double kUsualRadiusMm = 888.88;
constexpr double kRulerLines = 2.5; // Heights of a text between marks of the ruler, at least
constexpr double kRulerTick = 4.0;  // [px]
constexpr double kPauseSide = 16.0, kPauseGap = 2.0;
} // namespace

LayerRangeSlider::LayerRangeSlider(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  describe();
}

void LayerRangeSlider::setLayers(int count, std::vector<double> topMm, bool radii) {
  const bool changed = count != count_;
  count_ = std::max(0, count);
  topMm_ = std::move(topMm);
  radii_ = radii;
  topMm_.resize(topMm_.empty() ? 0 : static_cast<std::size_t>(count_), 0.0);
  setEnabled(count_ > 0);
  updateGeometry();
  update();
  if (!changed)
    return;
  held_ = Handle::None;
  if (single_) {
    single_ = false;
    emit singleChanged(false);
  }
  first_ = 0;
  last_ = std::max(0, count_ - 1);
  describe();
  emit rangeChanged(first_, last_);
}

void LayerRangeSlider::setRange(int first, int last) {
  const int top = std::max(0, count_ - 1);
  const int newLast = std::clamp(last, 0, top);
  const int newFirst = single_ ? newLast : std::clamp(first, 0, newLast);
  if (newFirst == first_ && newLast == last_)
    return;
  first_ = newFirst;
  last_ = newLast;
  describe();
  update();
  emit rangeChanged(first_, last_);
}

void LayerRangeSlider::setSingle(bool single) {
  if (single == single_)
    return;
  single_ = single;
  emit singleChanged(single_);
  setRange(single_ ? last_ : 0, last_);
  update();
}

void LayerRangeSlider::setPauses(std::vector<int> layers, bool pausable) {
  if (layers == pauses_ && pausable == pausable_)
    return;
  pauses_ = std::move(layers);
  pausable_ = pausable;
  describe();
  update();
}

void LayerRangeSlider::setEvents(std::vector<int> layers) {
  if (layers == events_)
    return;
  events_ = std::move(layers);
  update();
}

bool LayerRangeSlider::pausesAtUpper() const {
  return std::ranges::binary_search(pauses_, last_);
}

// Nothing is printed before the first layer.
QRectF LayerRangeSlider::pauseButton() const {
  if (!pausable_ || count_ == 0 || last_ == 0 || !isEnabled())
    return {};
  const QRectF handle = handleRect(Handle::Upper);
  return {handle.center().x() - 0.5 * kPauseSide, handle.top() - kPauseGap - kPauseSide, kPauseSide,
          kPauseSide};
}

void LayerRangeSlider::wishPause(bool pause) {
  if (!pauseButton().isEmpty() && pause != pausesAtUpper())
    emit pauseWished(last_, pause);
}

QSize LayerRangeSlider::sizeHint() const {
  return {minimumSizeHint().width(), 300};
}

// Reserve room for the labels of any usual part: a slider that widened with its labels would move
// the picture beside it.
QSize LayerRangeSlider::minimumSizeHint() const {
  int text = std::max(textWidth(QStringLiteral("0000")), textWidth(topText(kUsualRadiusMm, true)));
  for (const int layer : {0, count_ / 2, count_ - 1})
    if (layer >= 0)
      text = std::max(text, textWidth(labelOf(layer)));
  return {text + static_cast<int>(kHandleWidth) + 14, 120};
}

QRectF LayerRangeSlider::grooveRect() const {
  const double top =
      kHandleHeight + std::max(1.5 * fontMetrics().height(), kPauseSide + 2.0 * kPauseGap);
  const double x = width() - 0.5 * kHandleWidth - 4.0;
  return {x - 0.5 * kGrooveWidth, top, kGrooveWidth, std::max(1.0, height() - 2.0 * top)};
}

double LayerRangeSlider::yOf(int layer) const {
  const QRectF groove = grooveRect();
  const double share = count_ > 1 ? static_cast<double>(layer) / (count_ - 1) : 0.0;
  return groove.bottom() - share * groove.height();
}

int LayerRangeSlider::layerAt(double y) const {
  const QRectF groove = grooveRect();
  const double share = std::clamp((groove.bottom() - y) / groove.height(), 0.0, 1.0);
  return static_cast<int>(std::lround(share * std::max(0, count_ - 1)));
}

// The handles point away from each other, so that both can be grabbed if they touch.
QRectF LayerRangeSlider::handleRect(Handle handle) const {
  const double x = grooveRect().center().x() - 0.5 * kHandleWidth;
  return handle == Handle::Upper
             ? QRectF(x, yOf(last_) - kHandleHeight, kHandleWidth, kHandleHeight)
             : QRectF(x, yOf(first_), kHandleWidth, kHandleHeight);
}

LayerRangeSlider::Handle LayerRangeSlider::nearestHandle(double y) const {
  if (single_)
    return Handle::Upper;
  const double upper = std::abs(y - handleRect(Handle::Upper).center().y());
  const double lower = std::abs(y - handleRect(Handle::Lower).center().y());
  return lower < upper ? Handle::Lower : Handle::Upper;
}

QString LayerRangeSlider::labelOf(int layer) const {
  const QString number = locale().toString(layer + 1), top = topText(layer);
  return top.isEmpty() ? number : QStringLiteral("%1\n%2").arg(number, top);
}

QString LayerRangeSlider::topText(int layer) const {
  if (layer < 0 || static_cast<std::size_t>(layer) >= topMm_.size())
    return {};
  return topText(topMm_[static_cast<std::size_t>(layer)], radii_);
}

QString LayerRangeSlider::topText(double mm, bool radius) const {
  return radius ? tr("r %1 mm").arg(locale().toString(mm, 'f', 2))
                : tr("%1 mm").arg(locale().toString(mm, 'f', 1));
}

int LayerRangeSlider::textWidth(const QString& text) const {
  return fontMetrics().size(0, text).width(); // of the wider line
}

void LayerRangeSlider::moveHandle(Handle handle, int layer) {
  if (handle == Handle::Upper)
    setRange(single_ ? layer : std::min(first_, layer), layer);
  else if (handle == Handle::Lower)
    setRange(layer, std::max(last_, layer));
}

void LayerRangeSlider::describe() {
  setAccessibleName(tr("Shown layers"));
  setAccessibleDescription(
      count_ == 0 ? tr("No layers")
                  : tr("Layers %1 to %2 of %3").arg(first_ + 1).arg(last_ + 1).arg(count_) +
                        (pausesAtUpper() ? tr(", a pause before the last") : QString()));
  setToolTip(count_ == 0
                 ? tr("Layers appear here once they are planned.")
                 : tr("Layers %1 to %2 of %3. Up and down keys move the upper end, with Shift the "
                      "lower one; a double click shows a single layer.")
                       .arg(first_ + 1)
                       .arg(last_ + 1)
                       .arg(count_));
}

void LayerRangeSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || count_ == 0)
    return;
  const double y = event->position().y();
  if (pauseButton().contains(event->position())) {
    wishPause(!pausesAtUpper());
    return;
  }
  held_ = nearestHandle(y);
  emit dragging(true);
  // A click on a handle grabs it without moving it; elsewhere the nearer handle moves there.
  if (!handleRect(held_).adjusted(-4, -2, 4, 2).contains(event->position()))
    moveHandle(held_, layerAt(y));
  update();
}

void LayerRangeSlider::mouseMoveEvent(QMouseEvent* event) {
  if (held_ == Handle::None)
    return;
  const double away = held_ == Handle::Upper ? 0.5 * kHandleHeight : -0.5 * kHandleHeight;
  moveHandle(held_, layerAt(event->position().y() + away));
}

void LayerRangeSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || held_ == Handle::None)
    return;
  held_ = Handle::None;
  emit dragging(false);
  update();
}

void LayerRangeSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || count_ == 0)
    return;
  if (pauseButton().contains(event->position()))
    return; // the first click counts
  if (single_) {
    setSingle(false);
  } else {
    const int layer = layerAt(event->position().y());
    single_ = true;
    emit singleChanged(true);
    setRange(layer, layer);
    update();
  }
}

void LayerRangeSlider::keyPressEvent(QKeyEvent* event) {
  const bool lower = event->modifiers().testFlag(Qt::ShiftModifier) && !single_;
  const auto step = [&](int by) {
    if (lower)
      moveHandle(Handle::Lower, std::clamp(first_ + by, 0, last_));
    else
      moveHandle(Handle::Upper, std::clamp(last_ + by, single_ ? 0 : first_, count_ - 1));
  };
  switch (event->key()) {
  case Qt::Key_Plus:
    wishPause(true);
    break;
  case Qt::Key_Minus:
    wishPause(false);
    break;
  case Qt::Key_Up:
    step(1);
    break;
  case Qt::Key_Down:
    step(-1);
    break;
  case Qt::Key_PageUp:
    step(kPage);
    break;
  case Qt::Key_PageDown:
    step(-kPage);
    break;
  case Qt::Key_Home:
    single_ ? setRange(0, 0) : setRange(0, last_);
    break;
  case Qt::Key_End:
    setRange(first_, count_ - 1);
    break;
  default:
    QWidget::keyPressEvent(event);
  }
}

void LayerRangeSlider::wheelEvent(QWheelEvent* event) {
  wheelRest_ += event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  const int by = wheelRest_ / kWheelStep;
  wheelRest_ -= by * kWheelStep;
  event->accept();
  if (by == 0 || count_ == 0)
    return;
  if (event->modifiers().testFlag(Qt::ControlModifier) && !single_) {
    const int held = std::clamp(by, -first_, count_ - 1 - last_);
    setRange(first_ + held, last_ + held);
  } else if (event->modifiers().testFlag(Qt::ShiftModifier) && !single_) {
    moveHandle(Handle::Lower, std::clamp(first_ + by, 0, last_));
  } else {
    moveHandle(Handle::Upper, std::clamp(last_ + by, single_ ? 0 : first_, count_ - 1));
  }
}

bool LayerRangeSlider::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (pauseButton().contains(help->pos())) {
      QToolTip::showText(
          help->globalPos(),
          pausesAtUpper() ? tr("Remove the pause before layer %1").arg(last_ + 1)
                          : tr("Pause before layer %1: the arm goes beside the part and waits, for "
                               "example to put in an insert")
                                .arg(last_ + 1),
          this);
      return true;
    }
  }
  return QWidget::event(event);
}

void LayerRangeSlider::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    describe();
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LocaleChange)
    updateGeometry();
  QWidget::changeEvent(event);
}

QRectF LayerRangeSlider::labelRect(double y) const {
  const double right = grooveRect().center().x() - 0.5 * kHandleWidth - 4.0;
  const int lines = topMm_.empty() ? 1 : 2;
  const double tall = lines * fontMetrics().height();
  return {0.0, std::clamp(y - 0.5 * tall, 0.0, height() - tall), right, tall};
}

void LayerRangeSlider::paintLabel(QPainter& painter, int layer, double y) const {
  painter.drawText(labelRect(y), Qt::AlignRight | Qt::AlignVCenter, labelOf(layer));
}

std::vector<double> LayerRangeSlider::ruledMm() const {
  if (count_ < 2 || topMm_.size() != static_cast<std::size_t>(count_) ||
      !std::ranges::is_sorted(topMm_))
    return {};
  const double span = topMm_.back() - topMm_.front();
  const double most = grooveRect().height() / (kRulerLines * fontMetrics().height());
  if (span <= 0.0 || most < 1.0)
    return {};
  // The smallest of 1, 2, 5, 10, 20 ... whose marks have room.
  const double exponent = std::floor(std::log10(span / most));
  const double power = std::pow(10.0, std::abs(exponent));
  // A division gives the decimal number that is meant: 335 / 100, but not 335 * 0.01, is 3.35.
  const auto inMm = [&](double steps) { return exponent < 0.0 ? steps / power : steps * power; };
  double factor = 1.0;
  for (const double larger : {2.0, 5.0, 10.0})
    if (span / inMm(factor) > most)
      factor = larger;
  std::vector<double> marks;
  for (double at = std::ceil(topMm_.front() / inMm(factor)); inMm(at * factor) <= topMm_.back();
       ++at)
    marks.push_back(inMm(at * factor));
  return marks;
}

// Between the tops of two layers, as their distances may differ.
double LayerRangeSlider::yOfTop(double mm) const {
  const auto above = std::ranges::lower_bound(topMm_, mm);
  const int layer = static_cast<int>(above - topMm_.begin());
  if (layer == 0 || above == topMm_.end() || *above <= *(above - 1))
    return yOf(std::min(layer, count_ - 1));
  const double share = (mm - *(above - 1)) / (*above - *(above - 1));
  return yOf(layer - 1) + share * (yOf(layer) - yOf(layer - 1));
}

// Each pause as two bars across the groove, other events as diamonds, and the button.
void LayerRangeSlider::paintPauses(QPainter& painter) const {
  const QColor text = palette().color(QPalette::WindowText);
  const double x = grooveRect().center().x();
  painter.setPen(Qt::NoPen);
  for (const int layer : pauses_) {
    if (layer >= count_)
      break;
    const QRectF mark(x - 6.0, yOf(layer) - 4.0, 12.0, 8.0);
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawRoundedRect(mark, 2.0, 2.0);
    painter.setBrush(text);
    painter.drawRect(QRectF(x - 3.5, mark.top() + 1.0, 2.0, 6.0));
    painter.drawRect(QRectF(x + 1.5, mark.top() + 1.0, 2.0, 6.0));
  }
  for (const int layer : events_) {
    if (layer >= count_ || std::ranges::binary_search(pauses_, layer))
      continue;
    const QPointF middle(x, yOf(layer));
    constexpr double kHalf = 4.5;
    painter.setBrush(text);
    painter.drawPolygon(QPolygonF({middle - QPointF(0.0, kHalf), middle + QPointF(kHalf, 0.0),
                                   middle + QPointF(0.0, kHalf), middle - QPointF(kHalf, 0.0)}));
  }
  const QRectF button = pauseButton();
  if (button.isEmpty())
    return;
  painter.setPen(QPen(text, 1.0));
  painter.setBrush(palette().color(QPalette::Button));
  painter.drawEllipse(button.adjusted(0.5, 0.5, -0.5, -0.5));
  painter.setPen(QPen(text, 1.6));
  const QPointF middle = button.center();
  painter.drawLine(middle - QPointF(4.0, 0.0), middle + QPointF(4.0, 0.0));
  if (!pausesAtUpper())
    painter.drawLine(middle - QPointF(0.0, 4.0), middle + QPointF(0.0, 4.0));
}

void LayerRangeSlider::paintRuler(QPainter& painter, const std::vector<QRectF>& taken) const {
  const double x = grooveRect().left() - 2.0, line = fontMetrics().height();
  for (const double mm : ruledMm()) {
    const double y = yOfTop(mm);
    const QRectF text(0.0, y - 0.5 * line, x - kRulerTick - 3.0, line);
    if (std::ranges::any_of(taken, [&](const QRectF& one) { return one.intersects(text); }))
      continue;
    painter.drawLine(QPointF(x - kRulerTick, y), QPointF(x, y));
    painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter,
                     locale().toString(mm, 'g', QLocale::FloatingPointShortest));
  }
}

void LayerRangeSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette::ColorGroup group = isEnabled() ? QPalette::Active : QPalette::Disabled;
  const QColor full = palette().color(group, isEnabled() ? QPalette::Highlight : QPalette::Mid);
  const QRectF groove = grooveRect();
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(group, QPalette::Mid));
  painter.drawRoundedRect(groove, 0.5 * kGrooveWidth, 0.5 * kGrooveWidth);
  if (count_ == 0)
    return;
  painter.setBrush(full);
  painter.drawRect(
      QRectF(QPointF(groove.left(), yOf(last_)), QPointF(groove.right(), yOf(first_))));

  const double x = groove.center().x(), half = 0.5 * kHandleWidth;
  const double upper = yOf(last_), lower = yOf(first_);
  painter.setPen(QPen(palette().color(group, QPalette::Window), 1.0));
  painter.drawPolygon(QPolygonF({{x, upper},
                                 {x - half, upper - 0.4 * kHandleHeight},
                                 {x - half, upper - kHandleHeight},
                                 {x + half, upper - kHandleHeight},
                                 {x + half, upper - 0.4 * kHandleHeight}}));
  painter.drawPolygon(QPolygonF({{x, lower},
                                 {x - half, lower + 0.4 * kHandleHeight},
                                 {x - half, lower + kHandleHeight},
                                 {x + half, lower + kHandleHeight},
                                 {x + half, lower + 0.4 * kHandleHeight}}));

  painter.setPen(palette().color(group, QPalette::WindowText));
  const double tall = (topMm_.empty() ? 1.0 : 2.0) * fontMetrics().height();
  double upperLabel = upper - 0.5 * kHandleHeight, lowerLabel = lower + 0.5 * kHandleHeight;
  std::vector<QRectF> labels;
  if (first_ == last_) {
    labels = {labelRect(upper)};
    paintLabel(painter, last_, upper);
  } else {
    const double overlap = tall - (lowerLabel - upperLabel);
    if (overlap > 0.0) {
      upperLabel -= 0.5 * overlap;
      lowerLabel += 0.5 * overlap;
    }
    labels = {labelRect(upperLabel), labelRect(lowerLabel)};
    paintLabel(painter, last_, upperLabel);
    paintLabel(painter, first_, lowerLabel);
  }
  painter.setPen(palette().color(QPalette::Disabled, QPalette::WindowText));
  paintRuler(painter, labels);
  paintPauses(painter);
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 3.0, 3.0);
  }
}

} // namespace voluta::timeline
