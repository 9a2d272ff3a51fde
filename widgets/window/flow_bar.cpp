#include "window/flow_bar.h"

#include "forms/colours.h"
#include "forms/icons.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr int kHeight = 30, kGlyph = 12;
constexpr int kPadding = 14, kGap = 8, kCompactPadding = 6, kCompactGap = 5;
constexpr int kApart = 10; // Gap between the flow and the pages beside it

std::size_t indexAt(int index) {
  return static_cast<std::size_t>(index);
}

// Each state has its own shape, so that states do not differ by colour alone.
void paintGlyph(QPainter& painter, const QRectF& r, PageState state, const QPalette& palette,
                bool chosen) {
  const QColor plain = chosen ? palette.highlightedText().color() : forms::mutedColour(palette);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(plain, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QPointF c = r.center();
  switch (state) {
  case PageState::Nothing:
    painter.drawEllipse(r.adjusted(2, 2, -2, -2));
    break;
  case PageState::Running:
    painter.drawArc(r.adjusted(1, 1, -1, -1), 90 * 16, -270 * 16);
    break;
  case PageState::Done:
    painter.setPen(QPen(chosen ? plain : forms::goodColour(palette), 2.2, Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(
        QPolygonF({QPointF(r.left() + 1, c.y()), QPointF(c.x() - 1, r.bottom() - 2),
                   QPointF(r.right() - 1, r.top() + 2)}));
    break;
  case PageState::OutOfDate:
    painter.setPen(QPen(chosen ? plain : forms::warningColour(palette), 1.8));
    painter.drawEllipse(r.adjusted(1, 1, -1, -1));
    painter.drawLine(c, QPointF(c.x(), r.top() + 3));
    painter.drawLine(c, QPointF(c.x() + 3, c.y()));
    break;
  case PageState::Differs:
    forms::paintIcon(painter, r, forms::Icon::Warning, palette);
    break;
  case PageState::Blocked:
    painter.setPen(Qt::NoPen);
    painter.setBrush(forms::blockedColour(palette));
    painter.drawEllipse(r);
    painter.setPen(QPen(Qt::white, 2.0));
    painter.drawLine(QPointF(r.left() + 3, c.y()), QPointF(r.right() - 3, c.y()));
    break;
  }
}
} // namespace

FlowBar::FlowBar(QWidget* parent) : QWidget(parent) {
  setObjectName("flowBar");
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void FlowBar::setSteps(const std::vector<FlowStep>& steps) {
  const QString page = segments_.empty() ? QString() : segments_[indexAt(page_)].step.id;
  std::vector<Segment> segments;
  for (const FlowStep& step : steps)
    segments.push_back({step, state(step.id)});
  segments_ = std::move(segments);
  page_ = 0;
  setPage(page);
  updateGeometry();
  update();
}

int FlowBar::indexOf(const QString& id) const {
  const auto at = std::find_if(segments_.begin(), segments_.end(),
                               [&](const Segment& segment) { return segment.step.id == id; });
  return at == segments_.end() ? -1 : static_cast<int>(at - segments_.begin());
}

void FlowBar::setPage(const QString& id) {
  const int index = indexOf(id);
  if (index < 0)
    return;
  page_ = index;
  setAccessibleName(segments_[indexAt(index)].step.title);
  update();
}

void FlowBar::setState(const QString& id, PageState state) {
  if (const int index = indexOf(id); index >= 0)
    segments_[indexAt(index)].state = state;
  update();
}

PageState FlowBar::state(const QString& id) const {
  const int index = indexOf(id);
  return index < 0 ? PageState::Nothing : segments_[indexAt(index)].state;
}

int FlowBar::segmentWidth(const Segment& segment) const {
  return fontMetrics().horizontalAdvance(segment.step.title) + 2 * padding() + kGlyph + gap();
}

int FlowBar::padding() const {
  return compact_ ? kCompactPadding : kPadding;
}

int FlowBar::gap() const {
  return compact_ ? kCompactGap : kGap;
}

void FlowBar::setCompact(bool compact) {
  if (compact == compact_)
    return;
  compact_ = compact;
  updateGeometry();
  update();
}

QSize FlowBar::sizeHint() const {
  const QRect last = rectOf(static_cast<int>(segments_.size()) - 1);
  return {last.right() + 2, std::max(kHeight, fontMetrics().height() + 12)};
}

QRect FlowBar::segment(const QString& id) const {
  return rectOf(indexOf(id));
}

QRect FlowBar::rectOf(int index) const {
  if (index < 0)
    return {};
  int x = 0;
  for (int i = 0; i <= index; ++i) {
    const Segment& segment = segments_[indexAt(i)];
    if (segment.step.separate && i > 0 && !segments_[indexAt(i - 1)].step.separate)
      x += kApart;
    if (i < index)
      x += segmentWidth(segment);
  }
  return {x, 0, segmentWidth(segments_[indexAt(index)]), height()};
}

void FlowBar::paintSegment(QPainter& painter, int index) const {
  const Segment& segment = segments_[indexAt(index)];
  const QRect r = rectOf(index);
  const bool chosen = index == page_;
  paintGlyph(painter,
             QRectF(r.left() + padding(), r.center().y() - kGlyph / 2 + 0.5, kGlyph, kGlyph),
             segment.state, palette(), chosen);
  painter.setPen(chosen ? palette().highlightedText().color() : palette().text().color());
  painter.drawText(r.adjusted(padding() + kGlyph + gap(), 0, 0, 0),
                   Qt::AlignVCenter | Qt::AlignLeft, segment.step.title);
  if (index > 0 && segments_[indexAt(index - 1)].step.separate == segment.step.separate) {
    painter.setPen(palette().mid().color());
    painter.drawLine(r.left(), 1, r.left(), height() - 2);
  }
}

void FlowBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QRect flow, separate;
  const int count = static_cast<int>(segments_.size());
  for (int i = 0; i < count; ++i) {
    QRect& part = segments_[indexAt(i)].step.separate ? separate : flow;
    part |= rectOf(i);
  }
  QPainterPath outline;
  for (const QRect& r : {flow, separate})
    if (!r.isEmpty())
      outline.addRoundedRect(QRectF(r).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  painter.fillPath(outline, palette().base());
  painter.save();
  painter.setClipPath(outline);
  painter.fillRect(rectOf(count > 0 ? page_ : -1), palette().highlight());
  painter.restore();
  for (int i = 0; i < count; ++i)
    paintSegment(painter, i);
  painter.setPen(QPen(hasFocus() ? palette().highlight().color() : palette().mid().color(),
                      hasFocus() ? 2.0 : 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outline);
}

void FlowBar::choose(int index) {
  if (index == page_)
    return;
  const QString id = segments_[indexAt(index)].step.id;
  setPage(id);
  emit pageChosen(id);
}

void FlowBar::mousePressEvent(QMouseEvent* event) {
  for (int i = 0; i < static_cast<int>(segments_.size()); ++i)
    if (rectOf(i).contains(event->pos())) {
      choose(i);
      return;
    }
}

void FlowBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Right && page_ + 1 < static_cast<int>(segments_.size()))
    choose(page_ + 1);
  else if (event->key() == Qt::Key_Left && page_ > 0)
    choose(page_ - 1);
  else
    QWidget::keyPressEvent(event);
}

void FlowBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) {
    updateGeometry();
    update();
  }
  QWidget::changeEvent(event);
}

bool FlowBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (int i = 0; i < static_cast<int>(segments_.size()); ++i)
    if (rectOf(i).contains(help->pos())) {
      const Segment& segment = segments_[indexAt(i)];
      QToolTip::showText(help->globalPos(),
                         QString("%1: %2").arg(segment.step.title, stateName(segment.state)), this);
    }
  return true;
}

} // namespace voluta::window
