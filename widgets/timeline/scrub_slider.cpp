#include "timeline/scrub_slider.h"

#include "forms/colours.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace voluta::timeline {

namespace {
constexpr double kHandleRadius = 7.0;
constexpr double kGrooveHeight = 4.0;
constexpr double kMarkHalf = 4.0; // half of a mark's width
constexpr double kEventHalf = 1.5;
constexpr double kSpanGap = 4.0, kSpanHeight = 3.0;
constexpr double kSnapPx = 5.0; // a click this close to a mark selects the mark
} // namespace

ScrubSlider::ScrubSlider(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ScrubSlider::setEnd(double end) {
  end_ = std::max(0.0, end);
  position_ = std::clamp(position_, 0.0, end_);
  update();
}

void ScrubSlider::setPosition(double position) {
  const double held = std::clamp(position, 0.0, end_);
  if (held == position_)
    return;
  position_ = held;
  update();
}

void ScrubSlider::setMarks(std::vector<SliderMark> marks) {
  marks_ = std::move(marks);
  std::ranges::stable_sort(marks_, {}, &SliderMark::kind);
  update();
}

void ScrubSlider::setSpans(std::vector<SliderSpan> spans) {
  spans_ = std::move(spans);
  update();
}

QSize ScrubSlider::sizeHint() const {
  return {400, 30};
}

QSize ScrubSlider::minimumSizeHint() const {
  return {80, 30};
}

QRectF ScrubSlider::groove() const {
  return {kHandleRadius + 1.0, 0.5 * (height() - kGrooveHeight),
          width() - 2.0 * kHandleRadius - 2.0, kGrooveHeight};
}

double ScrubSlider::xOf(double position) const {
  const QRectF g = groove();
  return end_ > 0.0 ? g.left() + g.width() * position / end_ : g.left();
}

double ScrubSlider::positionAt(double x) const {
  const QRectF g = groove();
  return std::clamp((x - g.left()) / std::max(1.0, g.width()), 0.0, 1.0) * end_;
}

const ScrubSlider::SliderMark* ScrubSlider::markAt(double x) const {
  const SliderMark* nearest = nullptr;
  double distance = kSnapPx;
  for (const SliderMark& mark : marks_) {
    const double away = std::abs(xOf(mark.position) - x);
    if (away < distance || (nearest && away == distance && mark.kind > nearest->kind)) {
      nearest = &mark;
      distance = away;
    }
  }
  return nearest;
}

const ScrubSlider::SliderSpan* ScrubSlider::spanAt(double x) const {
  const auto at = std::ranges::find_if(spans_, [&](const SliderSpan& span) {
    return x >= xOf(span.from) - kSnapPx && x <= xOf(span.to) + kSnapPx;
  });
  return at == spans_.end() ? nullptr : &*at;
}

void ScrubSlider::follow(double x) {
  const double wanted = positionAt(x);
  if (wanted == position_)
    return;
  setPosition(wanted);
  emit moved(position_);
}

bool ScrubSlider::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const SliderMark* mark = markAt(help->pos().x());
  const SliderSpan* span = spanAt(help->pos().x());
  const QString what = mark ? mark->text : span ? span->text : QString();
  const QString position = textOf_ && end_ > 0.0
                               ? textOf_(mark ? mark->position : positionAt(help->pos().x()))
                               : QString();
  QToolTip::showText(help->globalPos(),
                     what.isEmpty() ? position : QStringLiteral("%1\n%2").arg(position, what),
                     this);
  return true;
}

void ScrubSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || end_ <= 0.0)
    return;
  held_ = true;
  emit dragging(true);
  const double x = event->position().x();
  const SliderMark* mark = markAt(x);
  follow(mark ? xOf(mark->position) : x);
  update();
}

void ScrubSlider::mouseMoveEvent(QMouseEvent* event) {
  if (held_)
    follow(event->position().x());
}

void ScrubSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !held_)
    return;
  held_ = false;
  emit dragging(false);
  update();
}

void ScrubSlider::contextMenuEvent(QContextMenuEvent* event) {
  if (end_ > 0.0)
    emit menuAsked(positionAt(event->pos().x()), event->globalPos());
}

// Blocking findings are squares above the groove, others triangles, and events bars, so that they
// differ without colour.
void ScrubSlider::paintMark(QPainter& painter, const SliderMark& mark) const {
  const double x = xOf(mark.position), top = 1.0;
  switch (mark.kind) {
  case MarkKind::Blocking:
    painter.setBrush(forms::blockedColour(palette()));
    painter.drawRect(QRectF(x - 0.75 * kMarkHalf, top, 1.5 * kMarkHalf, 1.5 * kMarkHalf));
    break;
  case MarkKind::Warning:
    painter.setBrush(forms::warningColour(palette()));
    painter.drawPolygon(QPolygonF({{x - kMarkHalf, top + 1.6 * kMarkHalf},
                                   {x, top},
                                   {x + kMarkHalf, top + 1.6 * kMarkHalf}}));
    break;
  case MarkKind::Event:
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawRoundedRect(QRectF(x - kEventHalf, top, 2.0 * kEventHalf, groove().top() - top),
                            1.0, 1.0);
    break;
  }
}

void ScrubSlider::paintSpans(QPainter& painter) const {
  const double top = groove().bottom() + kSpanGap;
  painter.setBrush(forms::warningColour(palette()));
  for (const SliderSpan& span : spans_) {
    const double from = xOf(span.from), to = xOf(span.to);
    painter.drawRect(QRectF(from, top, std::max(to - from, 1.0), kSpanHeight));
  }
}

void ScrubSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const QRectF g = groove();
  const QPalette::ColorGroup group = isEnabled() ? QPalette::Active : QPalette::Disabled;
  const QColor full = palette().color(group, isEnabled() ? QPalette::Highlight : QPalette::Mid);
  painter.setBrush(palette().color(group, QPalette::Mid));
  painter.drawRoundedRect(g, 0.5 * kGrooveHeight, 0.5 * kGrooveHeight);
  const double x = xOf(position_);
  painter.setBrush(full);
  painter.drawRoundedRect(QRectF(g.topLeft(), QPointF(x, g.bottom())), 0.5 * kGrooveHeight,
                          0.5 * kGrooveHeight);
  paintSpans(painter);
  for (const SliderMark& mark : marks_)
    paintMark(painter, mark);
  painter.setPen(QPen(palette().color(group, QPalette::Window), 1.5));
  painter.setBrush(full);
  const double radius = held_ ? kHandleRadius : kHandleRadius - 1.0;
  painter.drawEllipse(QPointF(x, g.center().y()), radius, radius);
}

} // namespace voluta::timeline
