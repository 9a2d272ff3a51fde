#include "robot/platform_gap.h"

#include "geometry/convex_polygon.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace voluta::robot {

namespace {

using Eigen::Vector2d;

double distanceTo(const std::vector<Vector2d>& polygon, const Vector2d& p) {
  if (geometry::inConvexPolygon(polygon, p))
    return 0.0;
  double nearest = INFINITY;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? std::clamp(along.dot(p - a) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + t * along - p).norm());
  }
  return nearest;
}

} // namespace

double platformGapMm(const Cell& cell) {
  const Prism* plate = nullptr;
  std::optional<double> gap;
  // The plate is the body's first shape (Cell::read), the stem follows.
  for (const Body& body : cell.bodies()) {
    if (body.role != BodyRole::Platform || body.frame != cell.workFrame())
      continue;
    for (const Shape& shape : body.shapes) {
      if (!plate) {
        plate = std::get_if<Prism>(&shape);
        continue;
      }
      constexpr double kMeetsMm = 0.1;
      if (const auto* f = std::get_if<Frustum>(&shape))
        for (const auto& [end, radius] : {std::pair{f->p0, f->r0}, std::pair{f->p1, f->r1}})
          if (std::abs(end.z() - plate->zMin) < kMeetsMm)
            gap = std::min(gap.value_or(INFINITY),
                           std::max(0.0, distanceTo(plate->polygon, end.head<2>()) - radius));
    }
  }
  return gap.value_or(0.0);
}

} // namespace voluta::robot
