// Invariants of every mesh that a reader returns.
#pragma once

#include "fuzz_target.h"
#include "geometry/triangle_mesh.h"

namespace voluta::fuzz {

inline void expectSound(const geometry::TriangleMesh& mesh) {
  expect(!mesh.triangles.empty(), "a mesh that was read has triangles");
  for (const Eigen::Vector3d& v : mesh.vertices)
    expect(v.allFinite(), "points are finite");
  for (const auto& t : mesh.triangles)
    for (const int v : t)
      expect(v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size(),
             "triangles are of points that there are");
}

} // namespace voluta::fuzz
