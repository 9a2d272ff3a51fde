#include "timeline/timeline_icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace voluta::timeline {

namespace {
// All shapes are within the unit square.
void addTriangle(QPainterPath& path, double tip, double base) {
  path.addPolygon(QPolygonF({{base, 0.2}, {tip, 0.5}, {base, 0.8}, {base, 0.2}}));
}

void addBar(QPainterPath& path, double left) {
  path.addRect(left, 0.2, 0.12, 0.6);
}

// Stacked sheets; the arrow's direction marks the new one.
void addSheets(QPainterPath& path, double left, double right) {
  for (const double top : {0.24, 0.46, 0.68})
    path.addRect(left, top, right - left, 0.1);
}

QPainterPath shapeOf(BarIcon which) {
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  switch (which) {
  case BarIcon::Play:
    addTriangle(path, 0.82, 0.26);
    break;
  case BarIcon::Pause:
    path.addRect(0.26, 0.2, 0.16, 0.6);
    path.addRect(0.58, 0.2, 0.16, 0.6);
    break;
  case BarIcon::NextMove:
    addTriangle(path, 0.66, 0.22);
    addBar(path, 0.68);
    break;
  case BarIcon::PreviousMove:
    addTriangle(path, 0.34, 0.78);
    addBar(path, 0.2);
    break;
  case BarIcon::NextLayer:
    addTriangle(path, 0.48, 0.12);
    addSheets(path, 0.56, 0.92);
    break;
  case BarIcon::PreviousLayer:
    addTriangle(path, 0.52, 0.88);
    addSheets(path, 0.08, 0.44);
    break;
  }
  return path;
}

class BarIconEngine : public QIconEngine {
public:
  explicit BarIconEngine(BarIcon which) : which_(which) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const double side = std::min(rect.width(), rect.height());
    const QPalette::ColorGroup group =
        mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.x() + 0.5 * (rect.width() - side),
                       rect.y() + 0.5 * (rect.height() - side));
    painter->scale(side, side);
    painter->fillPath(shapeOf(which_),
                      QGuiApplication::palette().color(group, QPalette::ButtonText));
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap drawn(size);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return drawn;
  }

  QIconEngine* clone() const override { return new BarIconEngine(which_); }

private:
  BarIcon which_;
};
} // namespace

QIcon icon(BarIcon which) {
  return QIcon(new BarIconEngine(which));
}

} // namespace voluta::timeline
