// Prisms as meshes.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::geometry {

// Returns the closed mesh of a prism between two heights, facing outward. `polygon`: convex,
// counter-clockwise. Precondition: bottom < top.
inline TriangleMesh prismOver(const std::vector<Eigen::Vector2d>& polygon, double bottom,
                              double top) {
  TriangleMesh mesh;
  const int n = static_cast<int>(polygon.size());
  for (const double z : {bottom, top})
    for (const Eigen::Vector2d& p : polygon)
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
    if (i > 0 && j > 0) {
      mesh.triangles.push_back({0, j, i});
      mesh.triangles.push_back({n, n + i, n + j});
    }
  }
  return mesh;
}

} // namespace voluta::geometry
