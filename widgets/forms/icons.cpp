#include "forms/icons.h"

#include "base/units.h"
#include "forms/colours.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QWidget>
#include <cmath>

namespace voluta::forms {

namespace {
// All shapes are drawn in a square of 16 x 16.
constexpr double kSide = 16.0;

QPen pen(const QColor& colour, double width) {
  return QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

void fill(QPainter& p, const QColor& colour) {
  p.setPen(Qt::NoPen);
  p.setBrush(colour);
}

void paintBlocked(QPainter& p, const QPalette& palette) {
  fill(p, blockedColour(palette));
  QPolygonF octagon;
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * base::kPi / 4.0;
    octagon << QPointF(8.0 + 7.4 * std::cos(angle), 8.0 + 7.4 * std::sin(angle));
  }
  p.drawPolygon(octagon);
  fill(p, palette.color(QPalette::Base));
  p.drawRoundedRect(QRectF(4.0, 6.8, 8.0, 2.4), 0.8, 0.8);
}

void paintWarning(QPainter& p, const QPalette& palette) {
  p.setPen(pen(warningColour(palette), 1.6));
  p.setBrush(warningColour(palette));
  p.drawPolygon(QPolygonF({QPointF(8.0, 2.0), QPointF(14.6, 13.6), QPointF(1.4, 13.6)}));
  fill(p, palette.color(QPalette::Base));
  p.drawRoundedRect(QRectF(7.1, 5.6, 1.8, 4.4), 0.8, 0.8);
  p.drawEllipse(QPointF(8.0, 11.9), 1.05, 1.05);
}

void paintNote(QPainter& p, const QPalette& palette) {
  fill(p, mutedColour(palette));
  p.drawEllipse(QPointF(8.0, 8.0), 7.0, 7.0);
  fill(p, palette.color(QPalette::Base));
  p.drawEllipse(QPointF(8.0, 4.6), 1.15, 1.15);
  p.drawRoundedRect(QRectF(7.1, 6.8, 1.8, 5.2), 0.8, 0.8);
}

void paintGood(QPainter& p, const QPalette& palette) {
  fill(p, goodColour(palette));
  p.drawEllipse(QPointF(8.0, 8.0), 7.2, 7.2);
  p.setPen(pen(palette.color(QPalette::Base), 1.9));
  p.setBrush(Qt::NoBrush);
  p.drawPolyline(QPolygonF({QPointF(4.7, 8.3), QPointF(7.1, 10.7), QPointF(11.5, 5.7)}));
}

void paintPending(QPainter& p, const QPalette& palette) {
  QPen ring = pen(mutedColour(palette), 1.4);
  ring.setCapStyle(Qt::FlatCap);
  ring.setDashPattern({2.2, 1.6});
  p.setPen(ring);
  p.setBrush(Qt::NoBrush);
  p.drawEllipse(QPointF(8.0, 8.0), 6.0, 6.0);
}

QPainterPath eyeOutline() {
  QPainterPath path(QPointF(1.2, 8.0));
  path.quadTo(8.0, 0.4, 14.8, 8.0);
  path.quadTo(8.0, 15.6, 1.2, 8.0);
  return path;
}

void paintEye(QPainter& p, const QPalette& palette, bool open) {
  const QColor colour = open ? palette.color(QPalette::Text) : mutedColour(palette);
  p.setPen(pen(colour, 1.3));
  p.setBrush(Qt::NoBrush);
  p.drawPath(eyeOutline());
  if (open) {
    p.setBrush(colour);
    p.drawEllipse(QPointF(8.0, 8.0), 2.0, 2.0);
  } else {
    p.drawLine(QPointF(3.0, 13.4), QPointF(13.0, 2.6));
  }
}

void paintReset(QPainter& p, const QPalette& palette) {
  p.setPen(pen(palette.color(QPalette::ButtonText), 1.6));
  p.setBrush(Qt::NoBrush);
  p.drawArc(QRectF(3.0, 3.4, 10.0, 10.0), -150 * 16, 290 * 16);
  p.setBrush(palette.color(QPalette::ButtonText));
  p.drawPolygon(QPolygonF({QPointF(2.2, 9.2), QPointF(6.2, 10.6), QPointF(2.9, 13.4)}));
}

void paintForeign(QPainter& p, const QPalette& palette) {
  p.setPen(pen(mutedColour(palette), 1.2));
  p.setBrush(Qt::NoBrush);
  p.drawEllipse(QPointF(8.0, 8.0), 6.4, 6.4);
  p.drawEllipse(QPointF(8.0, 8.0), 2.8, 6.4);
  p.drawLine(QPointF(1.6, 8.0), QPointF(14.4, 8.0));
}

class IconEngine : public QIconEngine {
public:
  explicit IconEngine(Icon which) : which_(which) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled)
      palette.setCurrentColorGroup(QPalette::Disabled);
    painter->save();
    if (mode == QIcon::Disabled)
      painter->setOpacity(0.45);
    paintIcon(*painter, rect, which_, palette);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap image(size);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return image;
  }

  QIconEngine* clone() const override { return new IconEngine(which_); }

private:
  Icon which_;
};
} // namespace

void paintIcon(QPainter& painter, const QRectF& where, Icon which, const QPalette& palette) {
  const double side = std::min(where.width(), where.height());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(where.center().x() - side / 2.0, where.center().y() - side / 2.0);
  painter.scale(side / kSide, side / kSide);
  switch (which) {
  case Icon::Blocked:
    paintBlocked(painter, palette);
    break;
  case Icon::Warning:
    paintWarning(painter, palette);
    break;
  case Icon::Note:
    paintNote(painter, palette);
    break;
  case Icon::Good:
    paintGood(painter, palette);
    break;
  case Icon::Pending:
    paintPending(painter, palette);
    break;
  case Icon::EyeOpen:
    paintEye(painter, palette, true);
    break;
  case Icon::EyeClosed:
    paintEye(painter, palette, false);
    break;
  case Icon::Reset:
    paintReset(painter, palette);
    break;
  case Icon::Foreign:
    paintForeign(painter, palette);
    break;
  }
  painter.restore();
}

QIcon icon(Icon which) {
  return QIcon(new IconEngine(which));
}

QPixmap iconBeside(const QWidget& text, Icon which) {
  const int side = text.fontMetrics().height();
  return icon(which).pixmap(QSize(side, side), text.devicePixelRatioF());
}

} // namespace voluta::forms
