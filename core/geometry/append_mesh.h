// Concatenation of two meshes.
#pragma once

#include "geometry/triangle_mesh.h"

namespace voluta::geometry {

// Appends the vertices and triangles of `other` to `mesh`.
inline void appendMesh(TriangleMesh& mesh, const TriangleMesh& other) {
  const int offset = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

} // namespace voluta::geometry
