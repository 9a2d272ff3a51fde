// Simplifies meshes for searches that only need the rough shape.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstddef>

namespace voluta::geometry {

// Collapses edges (Lindstrom and Turk 1998) until about `triangles` are left. A mesh that is small
// enough, or not manifold, is returned unchanged.
TriangleMesh simplified(const TriangleMesh& mesh, std::size_t triangles);

} // namespace voluta::geometry
