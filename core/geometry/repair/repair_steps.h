// The single steps of a repair. Each changes the mesh and says how much it did.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace voluta::geometry {

// Merges points closer than a tolerance, chains included, to their mean; only points on open edges.
// Of a ladder of tolerances from 1e-6 to 3e-4 of the diagonal, none above a third of the length
// that 1 % of the edges stay below, the least that leaves the fewest open edges. Returns points
// merged.
std::size_t mergeNearbyPoints(TriangleMesh& mesh);

// Drops triangles that name a vertex twice. Returns how many.
std::size_t dropCollapsedFaces(TriangleMesh& mesh);

// Drops triangles on the corners of an earlier one: repeats of the same direction, and pairs of
// opposite direction where other triangles hold at all their edges. Returns how many.
std::size_t dropDuplicateFaces(TriangleMesh& mesh);

// Drops components without volume, open or closed, beside components that have some. Returns
// triangles dropped.
std::size_t dropLooseSheets(TriangleMesh& mesh);

// Splits triangles whose open edge passes within `tolerance` (mm) of a vertex on an open edge.
// Returns the number of such vertices.
std::size_t splitTJunctions(TriangleMesh& mesh, double tolerance);

// Gives each fan of triangles at a non-manifold edge its own vertices. Returns vertices added.
std::size_t separateNonManifold(TriangleMesh& mesh);

struct ClosedHoles {
  std::size_t count = 0;
  std::size_t largestEdges = 0;
  Eigen::Vector3d largestAt = Eigen::Vector3d::Zero(); // mean of its rim
  std::size_t failed = 0;
};
// Fills every boundary loop with triangles between its vertices (CGAL triangulate_hole_polyline:
// least dihedral angles, then least area).
ClosedHoles closeHoles(TriangleMesh& mesh, const base::RunContext& ctx);

// Turns the inside-out components. Returns how many.
std::size_t turnInsideOut(TriangleMesh& mesh);

// Unites outward closed components that cut each other, `pairs` as selfIntersections() gives them.
// Components that cut themselves are left. Returns the number of components that went into unions.
std::size_t uniteComponents(TriangleMesh& mesh, const std::vector<std::pair<int, int>>& pairs,
                            const base::RunContext& ctx);

// Cuts self-intersections out of each component and closes the gaps; components where that fails
// are left. Returns whether anything changed.
bool removeSelfIntersections(TriangleMesh& mesh, const base::RunContext& ctx);

// Vertices that no triangle uses go, the others keep their order.
void dropUnusedVertices(TriangleMesh& mesh);

} // namespace voluta::geometry
