#include "robot/plate.h"

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

template <typename F> void forEachPlatformShape(const Cell& cell, F&& f) {
  for (const Body& body : cell.bodies())
    if (body.role == BodyRole::Platform && body.frame == cell.workFrame())
      for (const Shape& shape : body.shapes)
        f(shape);
}

} // namespace

const Prism* plateOf(const Cell& cell) {
  const Prism* plate = nullptr;
  forEachPlatformShape(cell, [&](const Shape& shape) {
    if (!plate)
      plate = std::get_if<Prism>(&shape);
  });
  return plate;
}

double platformGapMm(const Cell& cell) {
  constexpr double kMeetsMm = 0.1;
  const Prism* plate = plateOf(cell);
  if (!plate)
    return 0.0;
  std::optional<double> gap;
  forEachPlatformShape(cell, [&](const Shape& shape) {
    if (const auto* f = std::get_if<Frustum>(&shape))
      for (const auto& [end, radius] : {std::pair{f->p0, f->r0}, std::pair{f->p1, f->r1}})
        if (std::abs(end.z() - plate->zMin) < kMeetsMm)
          gap = std::min(gap.value_or(INFINITY),
                         std::max(0.0, distanceTo(plate->polygon, end.head<2>()) - radius));
  });
  return gap.value_or(0.0);
}

} // namespace voluta::robot
