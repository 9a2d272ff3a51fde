#include "placement/terraced.h"

#include "geometry/measures.h"

#include <algorithm>
#include <cmath>

namespace voluta::placement {

bool isTerraced(const geometry::TriangleMesh& mesh, const Eigen::Matrix3d& rotation) {
  constexpr double kVertical = 0.02;    // cosine: about one degree
  constexpr double kLevel = 1e-6;       // of the cosine: a slope of 0.08 degrees
  constexpr double kOtherShare = 1e-3;  // of the area: chamfers and slivers
  constexpr double kLowestShare = 1e-3; // of the height: faces that low lie on the plate
  const Eigen::Vector3d up = rotation.row(2);
  double lowest = INFINITY, highest = -INFINITY;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    lowest = std::min(lowest, up.dot(vertex));
    highest = std::max(highest, up.dot(vertex));
  }
  double whole = 0.0, other = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = geometry::triangleArea(mesh, t);
    whole += area;
    if (area <= 0.0)
      continue;
    const double slope = up.dot(geometry::triangleNormal(mesh, t));
    const bool isVertical = std::abs(slope) < kVertical;
    const bool facesUp = slope > 1.0 - kLevel;
    const bool lies = slope < kLevel - 1.0 &&
                      up.dot(mesh.corner(t, 0)) - lowest <= kLowestShare * (highest - lowest);
    if (!isVertical && !facesUp && !lies)
      other += area;
  }
  return other <= kOtherShare * whole;
}

} // namespace voluta::placement
