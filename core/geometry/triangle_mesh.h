// The common mesh type of parts, pieces, patches and platforms.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::geometry {

// Indexed triangles, counter-clockwise seen from outside [mm].
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;

  bool empty() const { return triangles.empty(); }
  const Eigen::Vector3d& corner(std::size_t triangle, int k) const {
    return vertices[static_cast<std::size_t>(triangles[triangle][static_cast<std::size_t>(k)])];
  }
};

} // namespace voluta::geometry
