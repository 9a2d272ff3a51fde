#include "window/unrolled/unrolled_canvas.h"

#include "scene/colouring.h"
#include "scene/theme.h"
#include "window/picture_area.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace voluta::window {

namespace {
constexpr double kMinPixelsPerMm = 0.05, kMaxPixelsPerMm = 2000.0;
constexpr double kBesideShare = 0.06; // Share of a turn shown beyond the seams
constexpr double kReachPixels = 7.0;  // Around the pointer
constexpr double kWheelZoom = 1.2, kKeyZoom = 1.3, kKeyMove = 0.15;
constexpr int kWheelStep = 120; // Eighths of a degree per notch

QColor colourOf(const scene::Colour& c) {
  return QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                          static_cast<float>(c[2]));
}

QColor between(const QColor& a, const QColor& b, double t) {
  const auto mix = [t](int from, int to) { return static_cast<int>(from + t * (to - from)); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

// Returns the smallest of 1, 2 or 5 times a power of ten that is at least `minStep`.
double niceStep(double minStep) {
  const double decade = std::pow(10.0, std::floor(std::log10(minStep)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * decade >= minStep * (1.0 - 1e-9))
      return times * decade;
  return 10.0 * decade;
}

QString tickText(const QLocale& locale, double value, double step) {
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return locale.toString(std::abs(value) < 1e-9 * step ? 0.0 : value, 'f', digits);
}

UnrolledLook lookOf(const QPalette& p) {
  UnrolledLook look;
  look.sheet = p.color(QPalette::Base);
  look.beside = between(p.color(QPalette::Base), p.color(QPalette::Window), 0.8);
  look.outline = p.color(QPalette::WindowText);
  look.seam = between(p.color(QPalette::WindowText), p.color(QPalette::Base), 0.4);
  look.chosen = colourOf(sceneTheme(p).marker);
  for (std::size_t i = 0; i < plan::kPathKinds; ++i)
    look.kinds[i] = colourOf(scene::categoricalColour(static_cast<int>(i)));
  return look;
}

// Paints the ticks of the visible frame, which is drawn at `area`.
void paintAxes(QPainter& painter, const QRectF& area, const UnrolledFrame& frame,
               const QWidget& widget) {
  const QLocale locale = widget.locale();
  const QPalette palette = widget.palette();
  const QFontMetrics metrics = widget.fontMetrics();
  const int tall = metrics.height();
  painter.setPen(palette.color(QPalette::Mid));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area);
  painter.setPen(palette.color(QPalette::WindowText));
  const QPointF low = frame.mmAt({0.0, area.height()}), high = frame.mmAt({area.width(), 0.0});
  const double wide = metrics.horizontalAdvance(QStringLiteral("-00.00")) + 14.0;
  const double stepU = niceStep(wide / frame.pixelsPerMm);
  for (double u = std::ceil(low.x() / stepU) * stepU; u <= high.x(); u += stepU) {
    const double x = area.left() + frame.pixelOf({u, 0.0}).x();
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 4));
    painter.drawText(QRectF(x - 0.5 * wide, area.bottom() + 4, wide, tall), Qt::AlignCenter,
                     tickText(locale, u, stepU));
  }
  const double stepV = niceStep(2.2 * tall / frame.pixelsPerMm);
  for (double v = std::ceil(low.y() / stepV) * stepV; v <= high.y(); v += stepV) {
    const double y = area.top() + frame.pixelOf({0.0, v}).y();
    painter.drawLine(QPointF(area.left() - 4, y), QPointF(area.left(), y));
    painter.drawText(QRectF(0.0, y - 0.5 * tall, area.left() - 6, tall),
                     Qt::AlignRight | Qt::AlignVCenter, tickText(locale, v, stepV));
  }
}
} // namespace

UnrolledCanvas::UnrolledCanvas(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  connect(&drawing_, &UnrolledDrawing::changed, this, [this] { update(); });
}

UnrolledCanvas::~UnrolledCanvas() = default;

void UnrolledCanvas::setContent(const UnrolledContent& content) {
  if (content == content_)
    return;
  const auto& before = content_.layer;
  const auto& now = content.layer;
  const bool other =
      now && (!before || std::abs(before->periodMm - now->periodMm) > 0.5 * now->periodMm ||
              !before->area.intersects(now->area));
  content_ = content;
  if (other || whole_)
    showAll();
  else
    redraw();
}

void UnrolledCanvas::setChosen(std::optional<std::size_t> waypoint) {
  chosenMm_ = waypoint && content_.layer ? placeOf(*content_.layer, *waypoint) : std::nullopt;
  update();
}

void UnrolledCanvas::setHint(const QString& hint) {
  hint_ = hint;
  update();
}

// Returns the plot area, with margins on the left and below for the numbers of the axes.
QRectF UnrolledCanvas::plot() const {
  const double left = fontMetrics().horizontalAdvance(QStringLiteral("-00.0")) + 8.0;
  const double below = 2.0 * fontMetrics().height() + 6.0;
  return {left, 4.0, std::max(20.0, width() - left - 6.0), std::max(20.0, height() - below - 4.0)};
}

QPointF UnrolledCanvas::pixelOf(const QPointF& mm) const {
  return plot().topLeft() + frame_.pixelOf(mm);
}

QPointF UnrolledCanvas::mmAt(const QPointF& pixel) const {
  return frame_.mmAt(pixel - plot().topLeft());
}

void UnrolledCanvas::setFrame(const QPointF& centreMm, double pixelsPerMm) {
  frame_.centreMm = centreMm;
  frame_.pixelsPerMm = std::clamp(pixelsPerMm, kMinPixelsPerMm, kMaxPixelsPerMm);
  redraw();
}

void UnrolledCanvas::showAll() {
  whole_ = true;
  if (!content_.layer || content_.layer->area.isEmpty()) {
    redraw();
    return;
  }
  const QRectF area = content_.layer->area;
  const QSizeF size = plot().size();
  const double wide = area.width() * (1.0 + 2.0 * kBesideShare), tall = area.height() * 1.06;
  setFrame(area.center(), std::min(size.width() / wide, size.height() / tall));
}

void UnrolledCanvas::zoomAbout(const QPointF& pixel, double factor) {
  if (!content_.layer)
    return;
  const QPointF held = mmAt(pixel);
  const double scale = std::clamp(frame_.pixelsPerMm * factor, kMinPixelsPerMm, kMaxPixelsPerMm);
  const double keep = frame_.pixelsPerMm / scale;
  whole_ = false;
  setFrame(held + keep * (frame_.centreMm - held), scale);
}

void UnrolledCanvas::redraw() {
  frame_.size = plot().size();
  frame_.pixelRatio = devicePixelRatioF();
  update();
  drawing_.draw({content_, frame_, lookOf(palette())});
}

void UnrolledCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRectF area = plot();
  const bool shown = content_.layer && !content_.layer->area.isEmpty();
  painter.fillRect(area, shown ? lookOf(palette()).beside : palette().color(QPalette::Base));
  if (!shown) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(area.adjusted(6, 6, -6, -6), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  paintLayer(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  paintMarks(painter);
  paintAxes(painter, area, frame_, *this);
  painter.drawText(
      QRectF(0.0, height() - fontMetrics().height() - 1.0, width() - 6.0, fontMetrics().height()),
      Qt::AlignCenter,
      fontMetrics().elidedText(tr("→ around, ↑ along [mm]"), Qt::ElideRight, width() - 6));
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0, Qt::DotLine));
    painter.drawRect(area.adjusted(1, 1, -1, -1));
  }
}

// Shows the last picture, moved and scaled, until the current one is ready.
void UnrolledCanvas::paintLayer(QPainter& painter) const {
  const auto& drawn = drawing_.drawn();
  if (!drawn || !drawn->content.layer)
    return;
  const QRectF area = plot();
  painter.save();
  painter.setClipRect(area);
  const UnrolledFrame& was = drawn->frame;
  if (was == frame_)
    painter.drawImage(area.topLeft(), drawing_.picture());
  else
    painter.drawImage(
        QRectF(pixelOf(was.mmAt({0.0, 0.0})), was.size * (frame_.pixelsPerMm / was.pixelsPerMm)),
        drawing_.picture());
  painter.restore();
}

void UnrolledCanvas::paintMarks(QPainter& painter) const {
  if (!chosenMm_)
    return;
  painter.save();
  painter.setClipRect(plot());
  const double period = content_.layer->periodMm;
  const QColor colour = lookOf(palette()).chosen;
  for (const double shift : {-period, 0.0, period}) {
    const QPointF at = pixelOf(*chosenMm_ + QPointF(shift, 0.0));
    painter.setPen(QPen(palette().color(QPalette::Base), 4.0));
    painter.drawEllipse(at, 6.0, 6.0);
    painter.setPen(QPen(colour, 2.0));
    painter.drawEllipse(at, 6.0, 6.0);
    if (period <= 0.0)
      break;
  }
  painter.restore();
}

std::optional<UnrolledHit> UnrolledCanvas::hitAt(const QPointF& pixel) const {
  if (!content_.layer || !plot().contains(pixel))
    return std::nullopt;
  return nearestPath(*content_.layer, mmAt(pixel), kReachPixels / frame_.pixelsPerMm);
}

void UnrolledCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (whole_)
    showAll();
  else
    redraw();
}

void UnrolledCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
    redraw();
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange)
    update();
  QWidget::changeEvent(event);
}

void UnrolledCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)
    return;
  pressedAt_ = last_ = event->position();
  pressed_ = true;
  moved_ = false;
}

void UnrolledCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (!pressed_) {
    if (content_.layer && plot().contains(at))
      emit hovered(mmAt(at), hitAt(at));
    else
      emit hovered({}, {});
    return;
  }
  moved_ = moved_ || (at - pressedAt_).manhattanLength() > QApplication::startDragDistance();
  if (!moved_ || !content_.layer)
    return;
  const QPointF by = (at - std::exchange(last_, at)) / frame_.pixelsPerMm;
  whole_ = false;
  setFrame(frame_.centreMm + QPointF(-by.x(), by.y()), frame_.pixelsPerMm);
}

void UnrolledCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (std::exchange(pressed_, false) && !moved_ && event->button() == Qt::LeftButton)
    emit clicked(hitAt(event->position()));
}

void UnrolledCanvas::mouseDoubleClickEvent(QMouseEvent*) {
  showAll();
}

void UnrolledCanvas::wheelEvent(QWheelEvent* event) {
  wheelRest_ += event->angleDelta().y();
  const int notches = wheelRest_ / kWheelStep;
  wheelRest_ -= notches * kWheelStep;
  event->accept();
  if (notches != 0)
    zoomAbout(event->position(), std::pow(kWheelZoom, notches));
}

void UnrolledCanvas::keyPressEvent(QKeyEvent* event) {
  const QPointF step =
      QPointF(frame_.size.width(), frame_.size.height()) * (kKeyMove / frame_.pixelsPerMm);
  const auto moveBy = [&](double u, double v) {
    whole_ = false;
    setFrame(frame_.centreMm + QPointF(u, v), frame_.pixelsPerMm);
  };
  switch (event->key()) {
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    zoomAbout(plot().center(), kKeyZoom);
    break;
  case Qt::Key_Minus:
    zoomAbout(plot().center(), 1.0 / kKeyZoom);
    break;
  case Qt::Key_Home:
    showAll();
    break;
  case Qt::Key_Left:
    moveBy(-step.x(), 0.0);
    break;
  case Qt::Key_Right:
    moveBy(step.x(), 0.0);
    break;
  case Qt::Key_Up:
    moveBy(0.0, step.y());
    break;
  case Qt::Key_Down:
    moveBy(0.0, -step.y());
    break;
  default:
    QWidget::keyPressEvent(event);
  }
}

void UnrolledCanvas::leaveEvent(QEvent* event) {
  emit hovered({}, {});
  QWidget::leaveEvent(event);
}

} // namespace voluta::window
