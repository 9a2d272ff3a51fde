#include "viewer/gizmo.h"

#include "base/units.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::viewer {

namespace {
using Eigen::Vector3d;

constexpr double kLengthPixels = 90.0, kGrabPixels = 8.0;
constexpr int kRingPoints = 64;
constexpr int kAll = 3, kRing = 4;
constexpr double kTiltShare = 0.72; // Share of an arrow's length: radius of the rings for tilting

// Blue, bluish green and orange, which colour-blind people can distinguish; the handles also show
// their letter.
QColor axisColour(int axis) {
  static const std::array<QColor, 4> kColours{QColor(213, 130, 0), QColor(0, 158, 115),
                                              QColor(0, 114, 178), QColor(130, 130, 130)};
  return kColours[static_cast<std::size_t>(axis)];
}

double distanceToLine(const QPolygonF& line, const QPointF& p) {
  double best = 1e9;
  for (int i = 0; i + 1 < line.size(); ++i) {
    const QPointF d = line[i + 1] - line[i];
    const double lengthSquared = QPointF::dotProduct(d, d);
    const double t = lengthSquared > 0.0
                         ? std::clamp(QPointF::dotProduct(p - line[i], d) / lengthSquared, 0.0, 1.0)
                         : 0.0;
    const QPointF off = p - (line[i] + t * d);
    best = std::min(best, std::hypot(off.x(), off.y()));
  }
  return best;
}

double snapped(double value, double step, bool snap) {
  return snap ? std::round(value / step) * step : value;
}
} // namespace

void Gizmo::setTool(Tool tool) {
  tool_ = tool;
  grabbed_ = -1;
  dragging_ = false;
}

std::vector<Gizmo::Handle> Gizmo::handles(const Projection& project, double mmPerPixel) const {
  const double length = kLengthPixels * mmPerPixel;
  std::vector<Handle> found;
  const auto arrow = [&](int k) {
    found.push_back({k,
                     QPolygonF({project(centre_ + 0.12 * length * axis(k)),
                                project(centre_ + length * axis(k))}),
                     false});
  };
  const auto ring = [&](int k, double radius) {
    QPolygonF line;
    const Vector3d a = axisAfter(k, 1), b = axisAfter(k, 2);
    for (int i = 0; i <= kRingPoints; ++i) {
      const double angle = 2.0 * base::kPi * i / kRingPoints;
      line << project(centre_ + radius * (std::cos(angle) * a + std::sin(angle) * b));
    }
    found.push_back({k, line, false});
  };
  switch (tool_) {
  case Tool::Move:
  case Tool::MoveRegion:
  case Tool::Scale:
    for (int k = 0; k < 3; ++k)
      arrow(k);
    if (tool_ != Tool::Scale) {
      const double near = 0.22 * length, far = 0.45 * length;
      QPolygonF square;
      for (const auto& [x, y] :
           {std::pair{near, near}, {far, near}, {far, far}, {near, far}, {near, near}})
        square << project(centre_ + x * axis(0) + y * axis(1));
      found.push_back({kAll, square, true});
    }
    break;
  case Tool::Rotate:
    for (int k = 0; k < 3; ++k)
      ring(k, length);
    break;
  case Tool::CutPlane:
    ring(0, kTiltShare * length);
    ring(1, kTiltShare * length);
    arrow(2);
    break;
  case Tool::Frame:
    for (int k = 0; k < 3; ++k)
      arrow(k);
    for (int k = 0; k < 3; ++k)
      ring(k + kRing, kTiltShare * length);
    break;
  case Tool::None:
  case Tool::LayFlat:
  case Tool::PickPoint:
  case Tool::Measure:
  case Tool::Regions:
  case Tool::Paint:
    break;
  }
  return found;
}

void Gizmo::paint(QPainter& painter, const Projection& project, double mmPerPixel,
                  const QPalette& palette) const {
  for (const Handle& handle : handles(project, mmPerPixel)) {
    const bool hot = handle.axis == grabbed_;
    if (dragging_ && !hot)
      continue;
    const QColor colour = hot ? palette.highlight().color() : axisColour(handle.axis % kRing);
    painter.setPen(QPen(palette.window().color(), hot ? 6.0 : 5.0, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(handle.line);
    painter.setPen(QPen(colour, hot ? 4.0 : 3.0, Qt::SolidLine, Qt::RoundCap));
    if (handle.closed) {
      QColor fill = colour;
      fill.setAlpha(70);
      painter.setBrush(fill);
      painter.drawPolygon(handle.line);
      continue;
    }
    painter.drawPolyline(handle.line);
    if (turns(handle.axis) || handle.axis == kAll)
      continue;
    const QPointF tip = handle.line.last();
    painter.setBrush(colour);
    painter.setPen(QPen(palette.window().color(), 1.0));
    if (tool_ == Tool::Scale) {
      painter.drawRect(QRectF(tip.x() - 6, tip.y() - 6, 12, 12));
    } else {
      painter.drawEllipse(tip, 8.0, 8.0);
      if (tool_ == Tool::CutPlane)
        continue;
      painter.setPen(Qt::white);
      QFont letter = painter.font();
      letter.setPixelSize(11);
      letter.setBold(true);
      painter.setFont(letter);
      painter.drawText(QRectF(tip.x() - 8, tip.y() - 8, 16, 16), Qt::AlignCenter,
                       QString(QChar('X' + handle.axis)));
    }
  }
}

bool Gizmo::hover(const QPointF& cursor, const Projection& project, double mmPerPixel) {
  if (dragging_)
    return true;
  grabbed_ = -1;
  double best = kGrabPixels;
  for (const Handle& handle : handles(project, mmPerPixel)) {
    double distance = distanceToLine(handle.line, cursor);
    if (handle.closed && handle.line.containsPoint(cursor, Qt::OddEvenFill))
      distance = 0.0;
    if (distance < best) {
      best = distance;
      grabbed_ = handle.axis;
    }
  }
  return grabbed_ >= 0;
}

double Gizmo::alongAxis(const Ray& ray) const {
  // Closest point of the axis to the ray.
  const Vector3d line = axis(grabbed_), between = centreAtBegin_ - ray.origin;
  const double along = line.dot(ray.direction);
  const double denominator = 1.0 - along * along;
  if (denominator < 1e-6)
    return beganAt_;
  return (along * ray.direction.dot(between) - line.dot(between)) / denominator;
}

std::optional<Vector3d> Gizmo::onPlane(const Ray& ray, const Vector3d& normal) const {
  const double along = normal.dot(ray.direction);
  if (std::abs(along) < 1e-3)
    return std::nullopt;
  return ray.origin + normal.dot(centreAtBegin_ - ray.origin) / along * ray.direction;
}

double Gizmo::angleOnRing(const Ray& ray, const QPointF& cursor) const {
  const Vector3d about = axis(grabbed_);
  if (std::abs(about.dot(ray.direction)) > 0.1)
    if (const auto hit = onPlane(ray, about)) {
      const Vector3d d = *hit - centreAtBegin_;
      return std::atan2(d.dot(axisAfter(grabbed_, 2)), d.dot(axisAfter(grabbed_, 1)));
    }
  // A ring seen edge-on is rotated by the cursor's movement along it.
  const QPointF d = cursor - centreOnScreen_;
  return (d.x() - d.y()) / kLengthPixels;
}

void Gizmo::begin(const QPointF& cursor, const Ray& ray, const Projection& project, double) {
  dragging_ = true;
  centreAtBegin_ = centre_;
  centreOnScreen_ = project(centre_);
  if (turns(grabbed_))
    beganAt_ = angleOnRing(ray, cursor);
  else if (tool_ == Tool::Scale)
    beganAt_ = std::max(
        4.0, std::hypot(cursor.x() - centreOnScreen_.x(), cursor.y() - centreOnScreen_.y()));
  else if (grabbed_ == kAll)
    beganOnPlane_ = onPlane(ray, Vector3d::UnitZ()).value_or(centre_);
  else
    beganAt_ = alongAxis(ray);
}

GizmoChange Gizmo::drag(const QPointF& cursor, const Ray& ray, bool snap) {
  GizmoChange change;
  if (turns(grabbed_)) {
    const double turned = std::remainder(angleOnRing(ray, cursor) - beganAt_, 2 * base::kPi);
    const double angle = snapped(turned, base::kPi / 12.0, snap);
    change.rotation = Eigen::AngleAxisd(angle, axis(grabbed_));
    change.text = QString::fromUtf8("%1°").arg(base::radiansToDegrees(angle), 0, 'f', 1);
  } else if (tool_ == Tool::Scale) {
    const double now =
        std::hypot(cursor.x() - centreOnScreen_.x(), cursor.y() - centreOnScreen_.y());
    change.scale = std::clamp(snapped(now / beganAt_, 0.05, snap), 0.01, 100.0);
    change.text = QString("%1 %").arg(100.0 * change.scale, 0, 'f', 1);
  } else {
    if (grabbed_ == kAll) {
      if (const auto hit = onPlane(ray, Vector3d::UnitZ()))
        change.moveMm = *hit - beganOnPlane_;
      change.moveMm.x() = snapped(change.moveMm.x(), 1.0, snap);
      change.moveMm.y() = snapped(change.moveMm.y(), 1.0, snap);
    } else {
      change.moveMm = snapped(alongAxis(ray) - beganAt_, 1.0, snap) * axis(grabbed_);
    }
    centre_ = centreAtBegin_ + change.moveMm;
    change.text =
        grabbed_ == kAll
            ? tr("%1, %2 mm").arg(change.moveMm.x(), 0, 'f', 1).arg(change.moveMm.y(), 0, 'f', 1)
            : tr("%1 mm").arg(change.moveMm.dot(axis(grabbed_)), 0, 'f', 1);
  }
  return change;
}

} // namespace voluta::viewer
