#include "together/plate_overlap.h"

#include "geometry/convex_polygon.h"
#include "robot/body.h"
#include "robot/cell.h"
#include "robot/plate.h"
#include "together/poses.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::together {

namespace {
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Polygon = std::vector<Vector2d>; // convex, counter-clockwise

constexpr double kMinMm = 0.1; // plates that meet at their edges do not overlap

// Calls visit(a, b) for each edge of a prism, in another frame.
template <typename Visit>
void visitEdges(const robot::Prism& prism, const Isometry3d& frame_T_prism, const Visit& visit) {
  const auto at = [&](std::size_t i, double z) -> Vector3d {
    const Vector2d& p = prism.polygon[i % prism.polygon.size()];
    return frame_T_prism * Vector3d(p.x(), p.y(), z);
  };
  for (std::size_t i = 0; i < prism.polygon.size(); ++i) {
    visit(at(i, prism.zMin), at(i + 1, prism.zMin));
    visit(at(i, prism.zMax), at(i + 1, prism.zMax));
    visit(at(i, prism.zMin), at(i, prism.zMax));
  }
}

// Returns the section of a prism at a height of another frame.
Polygon sectionAt(double z, const robot::Prism& prism, const Isometry3d& frame_T_prism) {
  std::vector<Vector2d> points;
  visitEdges(prism, frame_T_prism, [&](const Vector3d& a, const Vector3d& b) {
    const double above = a.z() - z, below = z - b.z();
    if (above * below < 0.0 || above + below == 0.0)
      return;
    points.push_back((a + above / (above + below) * (b - a)).head<2>());
  });
  return geometry::convexPolygon(std::move(points));
}

Vector2d inwards(const Polygon& polygon, std::size_t edge) {
  const Vector2d along = polygon[(edge + 1) % polygon.size()] - polygon[edge];
  return Vector2d(-along.y(), along.x()).normalized();
}

// Returns the shortest way that parts two polygons; negative: they are apart.
double depthOf(const Polygon& a, const Polygon& b) {
  double minimum = INFINITY;
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (std::size_t i = 0; i < one->size(); ++i) {
      const Vector2d normal = inwards(*one, i);
      double maximum = -INFINITY;
      for (const Vector2d& p : *other)
        maximum = std::max(maximum, normal.dot(p - (*one)[i]));
      minimum = std::min(minimum, maximum);
    }
  return minimum;
}

double sharedArea(Polygon a, const Polygon& b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Vector2d normal = inwards(b, i);
    Polygon kept;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const Vector2d &p = a[k], &q = a[(k + 1) % a.size()];
      const double atP = normal.dot(p - b[i]), atQ = normal.dot(q - b[i]);
      if (atP >= 0.0)
        kept.push_back(p);
      if ((atP < 0.0) != (atQ < 0.0))
        kept.push_back(p + atP / (atP - atQ) * (q - p));
    }
    a = std::move(kept);
  }
  double twice = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Vector2d &p = a[k], &q = a[(k + 1) % a.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * twice;
}

Isometry3d shared_T_plate(const PlacedCell& placed) {
  const robot::JointVector home = placed.cell.home();
  return placed.shared_T_world * placed.cell.base_T_world(home).inverse(Eigen::Isometry) *
         placed.cell.base_T_work(home);
}
} // namespace

std::optional<PlateOverlap> plateOverlap(const PlacedCell& one, const PlacedCell& other) {
  const robot::Prism *own = robot::plateOf(one.cell), *others = robot::plateOf(other.cell);
  if (!own || !others || isPartMoved(one.cell) || isPartMoved(other.cell))
    return std::nullopt;
  const Isometry3d own_T_other =
      shared_T_plate(one).inverse(Eigen::Isometry) * shared_T_plate(other);
  double low = INFINITY, high = -INFINITY;
  visitEdges(*others, own_T_other, [&](const Vector3d& a, const Vector3d& b) {
    low = std::min({low, a.z(), b.z()});
    high = std::max({high, a.z(), b.z()});
  });
  low = std::max(low, own->zMin);
  high = std::min(high, own->zMax);
  if (high - low < kMinMm)
    return std::nullopt;
  const Polygon section = sectionAt(0.5 * (low + high), *others, own_T_other);
  if (section.size() < 3)
    return std::nullopt;
  const double depth = depthOf(own->polygon, section);
  if (depth < kMinMm)
    return std::nullopt;
  return PlateOverlap{depth, sharedArea(own->polygon, section)};
}

} // namespace voluta::together
