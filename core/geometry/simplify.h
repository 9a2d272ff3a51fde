// A mesh with fewer triangles, for searches that only need its gross shape.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstddef>

namespace voluta::geometry {

// Edges collapsed (Lindstrom and Turk 1998) until no more than about `triangles` are left. A mesh
// that is small enough, or no manifold, comes back as it is.
TriangleMesh simplified(const TriangleMesh& mesh, std::size_t triangles);

} // namespace voluta::geometry
