// The boundary loops of a mesh with holes.
#pragma once

#include "geometry/triangle_mesh.h"

#include <vector>

namespace voluta::geometry {

// Returns closed loops of vertices along edges with one triangle, in the direction of a patch that
// fills the hole (opposite to the triangles). A loop that would visit a vertex twice is split.
// Chains that do not close (at misoriented triangles) are omitted. Sorted by their smallest vertex,
// which comes first.
std::vector<std::vector<int>> boundaryLoops(const TriangleMesh& mesh);

} // namespace voluta::geometry
