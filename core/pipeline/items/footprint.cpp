#include "pipeline/items/footprint.h"

#include "base/error.h"
#include "geometry/convex_polygon.h"
#include "geometry/triangle_queries.h"

#include <algorithm>
#include <limits>

namespace voluta::pipeline {

namespace {
using Eigen::Vector2d;

Eigen::Vector3d flat(const Vector2d& p) {
  return {p.x(), p.y(), 0.0};
}

// Returns the least distance of the corners of `a` to the sides of `b`.
double cornersToSides(const std::vector<Vector2d>& a, const std::vector<Vector2d>& b) {
  double minimum = std::numeric_limits<double>::infinity();
  for (const Vector2d& p : a)
    for (std::size_t i = 0; i < b.size(); ++i)
      minimum = std::min(
          minimum, geometry::distanceToSegment(flat(p), flat(b[i]), flat(b[(i + 1) % b.size()])));
  return minimum;
}

// Returns whether a side of `a` has all of `b` outside. Two convex polygons without such a side
// overlap.
bool separates(const std::vector<Vector2d>& a, const std::vector<Vector2d>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector2d side = a[(i + 1) % a.size()] - a[i];
    if (std::ranges::all_of(b, [&](const Vector2d& p) {
          const Vector2d to = p - a[i];
          return side.x() * to.y() - side.y() * to.x() <= 0.0;
        }))
      return true;
  }
  return false;
}
} // namespace

Footprint footprintOf(const geometry::TriangleMesh& placed, bool leans) {
  base::require(!placed.vertices.empty(), "footprintOf: a part");
  Footprint out{.outline = {}, .heightMm = 0.0, .leans = leans};
  std::vector<Vector2d> points;
  points.reserve(placed.vertices.size());
  for (const Eigen::Vector3d& v : placed.vertices) {
    points.emplace_back(v.head<2>());
    out.heightMm = std::max(out.heightMm, v.z());
  }
  out.outline = geometry::convexPolygon(std::move(points));
  return out;
}

double gapBetween(const Footprint& a, const Footprint& b) {
  if (!separates(a.outline, b.outline) && !separates(b.outline, a.outline))
    return 0.0;
  return std::min(cornersToSides(a.outline, b.outline), cornersToSides(b.outline, a.outline));
}

double headNeedsMm(const process::HeadShape& head, const Footprint& printed,
                   const Footprint& other) {
  double radius = 0.0;
  for (std::size_t i = 0; i < head.sections.size(); ++i) {
    const process::HeadSection& section = head.sections[i];
    if (printed.leans || section.zMm <= other.heightMm) {
      radius = std::max(radius, section.radiusMm);
      continue;
    }
    // The first section above the neighbour: of the cone to it, the part up to the neighbour.
    const process::HeadSection& below = head.sections[std::max<std::size_t>(i, 1) - 1];
    const double share = (other.heightMm - below.zMm) / std::max(section.zMm - below.zMm, 1e-9);
    if (share > 0.0 && share < 1.0)
      radius = std::max(radius, below.radiusMm + share * (section.radiusMm - below.radiusMm));
    break;
  }
  return radius;
}

} // namespace voluta::pipeline
