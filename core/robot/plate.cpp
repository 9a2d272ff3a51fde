#include "robot/plate.h"

#include "base/units.h"
#include "geometry/convex_polygon.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::robot {

namespace {

using Eigen::Vector2d;

double distanceTo(const std::vector<Vector2d>& polygon, const Vector2d& p) {
  if (geometry::inConvexPolygon(polygon, p))
    return 0.0;
  const auto flat = [](const Vector2d& q) { return Eigen::Vector3d(q.x(), q.y(), 0.0); };
  double nearest = INFINITY;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    nearest =
        std::min(nearest, geometry::distanceToSegment(flat(p), flat(polygon[i]),
                                                      flat(polygon[(i + 1) % polygon.size()])));
  return nearest;
}

// The end of a stem directly below the plate, and the plate's lateral distance from it.
struct Meeting {
  Vector2d at;
  double radius = 0.0, gapMm = INFINITY;
};

std::optional<Meeting> meetingOf(const Prism& plate, const std::vector<Shape>& shapes) {
  constexpr double kMeetsMm = 0.1;
  std::optional<Meeting> nearest;
  for (const Shape& shape : shapes)
    if (const auto* f = std::get_if<Frustum>(&shape))
      for (const auto& [end, radius] : {std::pair{f->p0, f->r0}, std::pair{f->p1, f->r1}}) {
        const Vector2d at = end.head<2>();
        const double gap = std::max(0.0, distanceTo(plate.polygon, at) - radius);
        if (std::abs(end.z() - plate.zMin) < kMeetsMm && (!nearest || gap < nearest->gapMm))
          nearest = {at, radius, gap};
      }
  return nearest;
}

const std::vector<Shape>* platformShapes(const Cell& cell) {
  for (const Body& body : cell.bodies())
    if (body.role == BodyRole::Platform && body.frame == cell.workFrame())
      return &body.shapes;
  return nullptr;
}

// Returns the n-th prism of the platform: 0 is the plate, 1 its foot.
const Prism* prismOf(const Cell& cell, int n) {
  if (const std::vector<Shape>* shapes = platformShapes(cell))
    for (const Shape& shape : *shapes)
      if (const auto* prism = std::get_if<Prism>(&shape); prism && n-- == 0)
        return prism;
  return nullptr;
}

} // namespace

const Prism* plateOf(const Cell& cell) {
  return prismOf(cell, 0);
}

const Prism* footOf(const Cell& cell) {
  return prismOf(cell, 1);
}

std::optional<Prism> footOf(const Prism& plate, const std::vector<Shape>& shapes) {
  const std::optional<Meeting> meeting = meetingOf(plate, shapes);
  if (!meeting || meeting->gapMm <= 0.0)
    return std::nullopt;
  constexpr int kCorners = 24;
  std::vector<Vector2d> points = plate.polygon;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = base::kTwoPi * k / kCorners;
    points.push_back(meeting->at + meeting->radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return Prism{geometry::convexPolygon(std::move(points)), plate.zMin,
               0.5 * (plate.zMin + plate.zMax)};
}

double platformGapMm(const Cell& cell) {
  const Prism* plate = plateOf(cell);
  if (!plate)
    return 0.0;
  const std::optional<Meeting> meeting = meetingOf(*plate, *platformShapes(cell));
  return meeting ? meeting->gapMm : 0.0;
}

} // namespace voluta::robot
