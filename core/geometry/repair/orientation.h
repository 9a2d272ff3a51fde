// Orientation of the triangles of a mesh.
#pragma once

#include "geometry/measures.h"
#include "geometry/triangle_mesh.h"

#include <vector>

namespace voluta::geometry {

// Returns for each connected component whether it has no boundary edge and each edge is used as
// often forward as backward.
std::vector<bool> closedComponents(const TriangleMesh& mesh, const Components& parts);

// Returns for each component whether it is closed and the winding number is negative on one of its
// sides (a shell that faces inward and is in no other, and shells inside of it). Flipping all of
// them makes outer shells face outward and keeps cavities cavities.
std::vector<bool> insideOutComponents(const TriangleMesh& mesh, const Components& parts);

// Flips triangles until neighbours across edges with two triangles agree; within each such patch
// the original orientation of the larger area is kept. Returns the number of flipped triangles. On
// a one-sided surface some edges stay inconsistent.
std::size_t orientConsistently(TriangleMesh& mesh);

} // namespace voluta::geometry
