#include "toolpath/coverage/bend_middle.h"

#include "base/error.h"
#include "toolpath/coverage/smooth_values.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr int kSmoothing = 4; // passes over values per segment

// Returns how far a share with that area per length extends to the side towards which its line
// bends with `curvature` [1/mm]: the solution x of x - curvature x^2 / 2 = areaMm.
double extentOf(double areaMm, double curvature) {
  if (std::abs(curvature * areaMm) < 1e-6)
    return areaMm;
  return (1.0 - std::sqrt(std::max(0.0, 1.0 - 2.0 * curvature * areaMm))) / curvature;
}

// Returns per segment the angle by which the curve turns to the left along it: half of the angles
// at both ends.
std::vector<double> turns(const PatchSurface& s, const SurfaceCurve& c, std::size_t segments) {
  const std::size_t n = c.points.size();
  std::vector<double> bend(segments, 0.0);
  const auto along = [&](std::size_t i) -> Vector3d {
    return c.points[(i + 1) % n].position - c.points[i].position;
  };
  for (std::size_t i = c.closed ? 0 : 1; i < segments; ++i) {
    const std::size_t before = (i + segments - 1) % segments;
    const Vector3d from = along(before), to = along(i);
    const Vector3d normal = s.interpolate(s.normal, c.points[i]);
    const double half = 0.5 * std::atan2(normal.dot(from.cross(to)), from.dot(to));
    bend[before] += half;
    bend[i] += half;
  }
  return bend;
}
} // namespace

std::vector<double> middleOfExtents(const PatchSurface& s, const SurfaceCurve& c,
                                    const CellShare& share) {
  const std::size_t segments = share.areaMm2.size(), n = c.points.size();
  base::require(segments + (c.closed ? 0 : 1) == n, "a share per segment");
  std::vector<double> length(segments), right(segments);
  std::vector<double> bend = turns(s, c, segments), left = share.leftMm2;
  for (std::size_t i = 0; i < segments; ++i) {
    length[i] = (c.points[(i + 1) % n].position - c.points[i].position).norm();
    right[i] = share.areaMm2[i] - left[i];
  }
  for (std::vector<double>* values : {&length, &bend, &left, &right})
    smoothValues(*values, c.closed, kSmoothing);
  std::vector<double> middle = share.lateralMm;
  for (std::size_t i = 0; i < segments; ++i) {
    const double area = left[i] + right[i];
    if (length[i] <= 0.0 || area <= 0.0)
      continue;
    const double curvature = bend[i] / length[i];
    const double l = extentOf(left[i] / length[i], curvature),
                 r = extentOf(right[i] / length[i], -curvature);
    // The mean distance of a share with these extents
    const double mean =
        (0.5 * (l * l - r * r) - curvature * (l * l * l + r * r * r) / 3.0) * length[i] / area;
    middle[i] += 0.5 * (l - r) - mean;
  }
  return middle;
}

} // namespace voluta::toolpath
