// Triangles of one mesh that cut each other.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <utility>
#include <vector>

namespace voluta::geometry {

// Pairs (i < j, sorted) of triangles that have more in common than the corners they share: exact
// predicates (CGAL). Triangles that share an edge count when they lie on each other. Degenerate
// triangles are passed over. Precondition: indices in range, coordinates finite.
std::vector<std::pair<int, int>> selfIntersections(const TriangleMesh& mesh,
                                                   const base::RunContext& ctx = {});

} // namespace voluta::geometry
