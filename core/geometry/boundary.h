// The rims of the holes of a mesh.
#pragma once

#include "geometry/triangle_mesh.h"

#include <vector>

namespace voluta::geometry {

// Closed loops of vertices along edges with one triangle, in the direction in which a patch that
// fills the hole runs (against the triangles). Loops do not visit a vertex twice: where they would,
// they are cut. Chains that do not close (at misoriented triangles) are left out. Ordered by
// their least vertex, which comes first.
std::vector<std::vector<int>> boundaryLoops(const TriangleMesh& mesh);

} // namespace voluta::geometry
