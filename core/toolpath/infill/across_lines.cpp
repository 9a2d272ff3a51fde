#include "toolpath/infill/across_lines.h"

#include "base/index.h"
#include "base/units.h"
#include "geometry/least_turn.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

using base::at;
using Eigen::Vector3d;

std::vector<double> acrossLines(const PatchSurface& s, double directionRad) {
  Vector3d mean = Vector3d::Zero(), centre = Vector3d::Zero();
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    mean += s.triangleArea[t] * s.triangleNormal[t];
    const auto& tri = s.triangles[t];
    centre += s.triangleArea[t] / 3 *
              (s.position[at(tri[0])] + s.position[at(tri[1])] + s.position[at(tri[2])]);
  }
  const double angle = std::remainder(directionRad + 0.5 * base::kPi, base::kPi);
  Vector3d normal(std::cos(angle), std::sin(angle), 0);
  if (mean.norm() > 0.1 * s.areaMm2) {
    const Vector3d m = mean.normalized();
    // Rotate with the mean plane of the patch, so that no patch is cut parallel to itself.
    normal = geometry::shortestRotation(Vector3d::UnitZ(), m) * normal;
  }
  std::vector<double> u(s.position.size());
  for (std::size_t v = 0; v < u.size(); ++v)
    u[v] = normal.dot(s.position[v]);
  // Where the surface is inclined to the cutting planes' normal, plane cuts are farther apart on
  // it. As long as that applies to little area, straight lines are better than geodesic ones.
  constexpr double kMinSine = 0.97;
  double leaning = 0.0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const double c = normal.dot(s.triangleNormal[t]);
    if (c * c > 1 - kMinSine * kMinSine)
      leaning += s.triangleArea[t];
  }
  if (leaning < 0.02 * s.areaMm2)
    return u;
  // A plane through the centroid may miss a hollow surface; a plane through a vertex cannot.
  std::vector<double> sorted = u;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(u.size() / 2));
  std::vector<double> geodesic = distanceToSection(s, normal, sorted[u.size() / 2] + 1e-7);
  const bool whole =
      !geodesic.empty() && std::ranges::all_of(geodesic, [](double d) { return std::isfinite(d); });
  return whole ? geodesic : u;
}

} // namespace voluta::toolpath
