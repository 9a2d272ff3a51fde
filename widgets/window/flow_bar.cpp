#include "window/flow_bar.h"

#include "forms/colours.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

namespace voluta::window {

namespace {
constexpr int kHeight = 30, kPadding = 14, kGlyph = 12, kGap = 8;
constexpr int kApart = 10; // Compare from the flow

// A shape a state, so that no state is told by colour alone.
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

QString pageName(Page page) {
  switch (page) {
  case Page::Prepare:
    return FlowBar::tr("Prepare");
  case Page::Layers:
    return FlowBar::tr("Layers");
  case Page::Simulate:
    return FlowBar::tr("Simulate");
  case Page::Export:
    return FlowBar::tr("Export");
  default:
    return FlowBar::tr("Compare");
  }
}

QString stateName(PageState state) {
  switch (state) {
  case PageState::Nothing:
    return FlowBar::tr("nothing yet");
  case PageState::Running:
    return FlowBar::tr("running");
  case PageState::Done:
    return FlowBar::tr("done");
  case PageState::OutOfDate:
    return FlowBar::tr("out of date");
  default:
    return FlowBar::tr("blocked: see the findings");
  }
}

FlowBar::FlowBar(QWidget* parent) : QWidget(parent) {
  setObjectName("flowBar");
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void FlowBar::setPage(Page page) {
  page_ = page;
  setAccessibleName(pageName(page));
  update();
}

void FlowBar::setState(Page page, PageState state) {
  states_[static_cast<std::size_t>(page)] = state;
  update();
}

int FlowBar::segmentWidth(int page) const {
  return fontMetrics().horizontalAdvance(pageName(static_cast<Page>(page))) + 2 * kPadding +
         kGlyph + kGap;
}

QSize FlowBar::sizeHint() const {
  int width = 1 + kApart;
  for (int i = 0; i < kPageCount; ++i)
    width += segmentWidth(i);
  return {width, std::max(kHeight, fontMetrics().height() + 12)};
}

QRect FlowBar::segment(Page page) const {
  int x = page == Page::Compare ? kApart : 0;
  for (int i = 0; i < static_cast<int>(page); ++i)
    x += segmentWidth(i);
  return {x, 0, segmentWidth(static_cast<int>(page)), height()};
}

void FlowBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRect aside = segment(Page::Compare), flow(0, 0, aside.left() - kApart, height());
  QPainterPath outline;
  for (const QRect& r : {flow, aside})
    outline.addRoundedRect(QRectF(r).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  painter.fillPath(outline, palette().base());
  painter.save();
  painter.setClipPath(outline);
  painter.fillRect(segment(page_), palette().highlight());
  painter.restore();
  for (int i = 0; i < kPageCount; ++i) {
    const auto page = static_cast<Page>(i);
    const QRect r = segment(page);
    const bool chosen = page == page_;
    paintGlyph(painter,
               QRectF(r.left() + kPadding, r.center().y() - kGlyph / 2 + 0.5, kGlyph, kGlyph),
               state(page), palette(), chosen);
    painter.setPen(chosen ? palette().highlightedText().color() : palette().text().color());
    painter.drawText(r.adjusted(kPadding + kGlyph + kGap, 0, 0, 0),
                     Qt::AlignVCenter | Qt::AlignLeft, pageName(page));
    if (i > 0 && page != Page::Compare) {
      painter.setPen(palette().mid().color());
      painter.drawLine(r.left(), 1, r.left(), height() - 2);
    }
  }
  painter.setPen(QPen(hasFocus() ? palette().highlight().color() : palette().mid().color(),
                      hasFocus() ? 2.0 : 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outline);
}

void FlowBar::choose(Page page) {
  if (page == page_)
    return;
  setPage(page);
  emit pageChosen(page);
}

void FlowBar::mousePressEvent(QMouseEvent* event) {
  for (int i = 0; i < kPageCount; ++i)
    if (segment(static_cast<Page>(i)).contains(event->pos()))
      choose(static_cast<Page>(i));
}

void FlowBar::keyPressEvent(QKeyEvent* event) {
  const int at = static_cast<int>(page_);
  if (event->key() == Qt::Key_Right && at + 1 < kPageCount)
    choose(static_cast<Page>(at + 1));
  else if (event->key() == Qt::Key_Left && at > 0)
    choose(static_cast<Page>(at - 1));
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
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    for (int i = 0; i < kPageCount; ++i) {
      const auto page = static_cast<Page>(i);
      if (segment(page).contains(help->pos()))
        QToolTip::showText(help->globalPos(),
                           QString("%1: %2").arg(pageName(page), stateName(state(page))), this);
    }
    return true;
  }
  return QWidget::event(event);
}

} // namespace voluta::window
