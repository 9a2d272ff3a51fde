#include "robot/shape/triangle_cut.h"

namespace voluta::robot {

using Eigen::Vector3d;

namespace {

void addCorners(const std::vector<Vector3d>& polygon, std::vector<Corners>& triangles) {
  for (std::size_t k = 2; k < polygon.size(); ++k)
    triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
}

} // namespace

std::array<std::vector<Corners>, 2> cut(const std::vector<Corners>& triangles, const Plane& plane) {
  std::array<std::vector<Corners>, 2> sides;
  for (const Corners& triangle : triangles) {
    std::array<double, 3> height{};
    for (std::size_t k = 0; k < 3; ++k)
      height[k] = plane.normal.dot(triangle[k]) - plane.offset;
    if (height[0] <= 0 && height[1] <= 0 && height[2] <= 0) {
      sides[0].push_back(triangle);
    } else if (height[0] >= 0 && height[1] >= 0 && height[2] >= 0) {
      sides[1].push_back(triangle);
    } else {
      std::vector<Vector3d> below, above;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        (height[k] <= 0 ? below : above).push_back(triangle[k]);
        if ((height[k] <= 0) != (height[next] <= 0)) {
          const double t = height[k] / (height[k] - height[next]);
          const Vector3d at = triangle[k] + t * (triangle[next] - triangle[k]);
          below.push_back(at);
          above.push_back(at);
        }
      }
      addCorners(below, sides[0]);
      addCorners(above, sides[1]);
    }
  }
  return sides;
}

} // namespace voluta::robot
