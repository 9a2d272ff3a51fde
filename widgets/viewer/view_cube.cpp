#include "viewer/view_cube.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyleHints>

namespace voluta::viewer {

namespace {
using Eigen::Vector3d;

struct Face {
  Vector3d normal, right, up; // Of the face as read from outside
};

const std::array<Face, 6>& faces() {
  static const std::array<Face, 6> kFaces{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                           {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                           {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                           {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                           {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                           {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}}}};
  return kFaces;
}

QString faceName(int face) {
  switch (face) {
  case 0:
    return ViewCube::tr("Front");
  case 1:
    return ViewCube::tr("Back");
  case 2:
    return ViewCube::tr("Left");
  case 3:
    return ViewCube::tr("Right");
  case 4:
    return ViewCube::tr("Top");
  default:
    return ViewCube::tr("Bottom");
  }
}
} // namespace

ViewCube::ViewCube(QWidget* parent) : QWidget(parent) {
  setObjectName("viewCube");
  setMouseTracking(true);
  setCursor(Qt::PointingHandCursor);
  setFixedSize(sizeHint());
  setToolTip(tr("Click a face to look from there, drag to turn the view"));
}

void ViewCube::setAxes(const Eigen::Matrix3d& axes) {
  axes_ = axes;
  update();
}

QPointF ViewCube::projected(const Vector3d& corner) const {
  const Vector3d seen = axes_.transpose() * corner;
  const double half = 0.26 * width();
  return {0.5 * width() + half * seen.x(), 0.5 * height() - half * seen.y()};
}

std::array<QPointF, 4> ViewCube::corners(int face) const {
  const Face& f = faces()[static_cast<std::size_t>(face)];
  return {projected(f.normal - f.right + f.up), projected(f.normal + f.right + f.up),
          projected(f.normal + f.right - f.up), projected(f.normal - f.right - f.up)};
}

int ViewCube::faceAt(const QPointF& place) const {
  for (int face = 0; face < 6; ++face) {
    if (faces()[static_cast<std::size_t>(face)].normal.dot(axes_.col(2)) <= 0.02)
      continue;
    const auto c = corners(face);
    if (QPolygonF({c[0], c[1], c[2], c[3]}).containsPoint(place, Qt::OddEvenFill))
      return face;
  }
  return -1;
}

void ViewCube::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr double kText = 100.0; // Size of a face in its own coordinates
  const QPolygonF square({{0, 0}, {kText, 0}, {kText, kText}, {0, kText}});
  for (int face = 0; face < 6; ++face) {
    const double facing = faces()[static_cast<std::size_t>(face)].normal.dot(axes_.col(2));
    if (facing <= 0.0)
      continue;
    const auto c = corners(face);
    const QPolygonF seen({c[0], c[1], c[2], c[3]});
    const bool hot = face == hovered_;
    QColor fill = hot ? palette().highlight().color() : palette().button().color();
    fill = fill.darker(static_cast<int>(100.0 + 22.0 * (1.0 - facing)));
    fill.setAlpha(235);
    painter.setBrush(fill);
    painter.setPen(QPen(palette().mid().color(), 1.0));
    painter.drawPolygon(seen);
    QTransform onto;
    if (facing < 0.15 || !QTransform::quadToQuad(square, seen, onto))
      continue;
    painter.save();
    painter.setTransform(onto, true);
    QFont bold = font();
    bold.setPixelSize(26);
    // Names differ in length between languages.
    while (bold.pixelSize() > 12 &&
           QFontMetricsF(bold).horizontalAdvance(faceName(face)) > 0.9 * kText)
      bold.setPixelSize(bold.pixelSize() - 1);
    painter.setFont(bold);
    painter.setPen(hot ? palette().highlightedText().color() : palette().buttonText().color());
    painter.drawText(QRectF(0, 0, kText, kText), Qt::AlignCenter, faceName(face));
    painter.restore();
  }
}

void ViewCube::mousePressEvent(QMouseEvent* event) {
  pressedAt_ = last_ = event->position();
  dragged_ = false;
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) {
    const QPointF d = event->position() - last_;
    if (dragged_ || (event->position() - pressedAt_).manhattanLength() >
                        QGuiApplication::styleHints()->startDragDistance()) {
      dragged_ = true;
      emit orbit(4.0 * d.x(), -4.0 * d.y());
      last_ = event->position();
    }
    return;
  }
  const int face = faceAt(event->position());
  if (face != hovered_) {
    hovered_ = face;
    update();
  }
}

void ViewCube::mouseReleaseEvent(QMouseEvent* event) {
  const int face = faceAt(event->position());
  if (!dragged_ && face >= 0)
    emit viewFrom(faces()[static_cast<std::size_t>(face)].normal);
}

void ViewCube::leaveEvent(QEvent* event) {
  hovered_ = -1;
  update();
  QWidget::leaveEvent(event);
}

} // namespace voluta::viewer
