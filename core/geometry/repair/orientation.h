// Which way the triangles of a mesh face.
#pragma once

#include "geometry/measures.h"
#include "geometry/triangle_mesh.h"

#include <vector>

namespace voluta::geometry {

// For each connected component: no boundary edge, each edge as often forward as backward.
std::vector<bool> closedComponents(const TriangleMesh& mesh, const Components& parts);

// For each component: closed, and the winding number falls below zero on one of its sides (a shell
// that faces inward and lies in nothing, and what lies in such a shell). Turning all of them makes
// outer shells face outward and keeps cavities cavities.
std::vector<bool> insideOutComponents(const TriangleMesh& mesh, const Components& parts);

// Turns triangles until neighbours over edges with two triangles agree; within each such patch the
// side with more area as it was is kept. Returns how many were turned. A one-sided surface keeps
// disagreeing edges.
std::size_t orientConsistently(TriangleMesh& mesh);

} // namespace voluta::geometry
