// The single steps of a repair. Each changes the mesh and says how much it did.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <array>
#include <cstddef>
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
// opposite direction where other triangles hold at all their edges; the pairs go to `sheets`.
// Returns how many.
std::size_t dropDuplicateFaces(TriangleMesh& mesh, TriangleMesh& sheets);

// Moves components without volume, open or closed, to `sheets`. Returns triangles moved.
std::size_t separateSheets(TriangleMesh& mesh, TriangleMesh& sheets);

// Splits triangles whose open edge passes within `tolerance` (mm) of a vertex on an open edge.
// Returns the number of such vertices.
std::size_t splitTJunctions(TriangleMesh& mesh, double tolerance);

// Gives each fan of triangles at a non-manifold edge its own vertices. Returns vertices added.
std::size_t separateNonManifold(TriangleMesh& mesh);

// A patch that would close a boundary loop.
struct RimCap {
  std::vector<int> rim;                      // as boundaryLoops() has it
  std::vector<std::array<int, 3>> triangles; // between its vertices; none: they do not make a patch
  double areaMm2 = 0.0;
  // Whether the surface ends at the rim: along three quarters of it or more the patch folds away
  // from the surface by more than 45 degrees. Where it does not, the patch continues the surface.
  bool endsSurface = false;
};
// A patch for each boundary loop (CGAL triangulate_hole_polyline: least dihedral angles, then least
// area; Liepa 2003).
std::vector<RimCap> rimCaps(const TriangleMesh& mesh, const base::RunContext& ctx);

// Turns the inside-out components. Returns how many.
std::size_t turnInsideOut(TriangleMesh& mesh);

// Vertices that no triangle uses go, the others keep their order.
void dropUnusedVertices(TriangleMesh& mesh);

} // namespace voluta::geometry
