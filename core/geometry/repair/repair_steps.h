// The steps of a repair. Each changes the mesh and returns how much it changed.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::geometry {

// Merges points that are closer than a tolerance, including chains, to their mean; only points on
// open edges. Tries tolerances from 1e-6 to 3e-4 of the diagonal, none above a third of the 1st
// percentile of the edge lengths, and uses the smallest that leaves the fewest open edges. Returns
// the number of points merged.
std::size_t mergeNearbyPoints(TriangleMesh& mesh);

// Drops triangles with a repeated vertex. Returns their number.
std::size_t dropCollapsedFaces(TriangleMesh& mesh);

// Drops triangles with the same corners as an earlier one: repetitions of the same direction, and
// pairs of opposite direction if other triangles share all their edges; the pairs are moved to
// `sheets`. Returns the number of triangles.
std::size_t dropDuplicateFaces(TriangleMesh& mesh, TriangleMesh& sheets);

// Moves components without volume, open or closed, to `sheets`. Returns the number of triangles
// moved.
std::size_t separateSheets(TriangleMesh& mesh, TriangleMesh& sheets);

// Splits triangles whose open edge passes within `tolerance` [mm] of a vertex on an open edge.
// Returns the number of such vertices.
std::size_t splitTJunctions(TriangleMesh& mesh, double tolerance);

// Gives each fan of triangles at a non-manifold edge separate vertices. Returns the number of
// vertices added.
std::size_t separateNonManifold(TriangleMesh& mesh);

// A patch that would close a boundary loop.
struct RimCap {
  std::vector<int> rim;                      // as in boundaryLoops()
  std::vector<std::array<int, 3>> triangles; // between its vertices; empty if no patch was found
  double areaMm2 = 0.0;
  // Whether the surface ends at the rim: along at least three quarters of the rim the patch is
  // folded by more than 45 degrees relative to the surface. Otherwise the patch continues the
  // surface.
  bool endsSurface = false;
};
// Returns a patch for each boundary loop (CGAL triangulate_hole_polyline: smallest dihedral angles,
// then smallest area; Liepa 2003).
std::vector<RimCap> rimCaps(const TriangleMesh& mesh, const base::RunContext& ctx);

// Flips the inside-out components. Returns their number.
std::size_t flipInsideOut(TriangleMesh& mesh);

// Removes vertices that no triangle uses; the others keep their order.
void dropUnusedVertices(TriangleMesh& mesh);

} // namespace voluta::geometry
