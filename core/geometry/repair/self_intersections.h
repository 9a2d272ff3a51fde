// Self-intersections of a mesh.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <utility>
#include <vector>

namespace voluta::geometry {

// Returns pairs (i < j, sorted) of triangles that intersect beyond the corners they share: exact
// predicates (CGAL). Triangles that share an edge count if they overlap. Degenerate triangles are
// skipped. Precondition: indices in range, coordinates finite.
std::vector<std::pair<int, int>> selfIntersections(const TriangleMesh& mesh,
                                                   const base::RunContext& ctx = {});

} // namespace voluta::geometry
