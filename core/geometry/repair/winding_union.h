// The boundary of the volume that one or several closed shells enclose.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <optional>
#include <utility>
#include <vector>

namespace voluta::geometry {

struct WindingUnion {
  TriangleMesh mesh;
  double insideOutMm3 = 0.0; // volume of the points with a negative winding number, which is lost

  // As a share of the enclosed volume.
  double lostShare() const;
  bool losesTooMuch() const { return lostShare() > kMaxLost; }

private:
  // Loops of offset surfaces are below this, lobes of a part are not. Equal to the share of a
  // surface that a repair may change without being asked (open_surface.h).
  static constexpr double kMaxLost = 0.01;
};

// Returns the boundary of the points with a winding number of at least 1: overlapping shells are
// united, loops of self-intersecting surfaces are removed, cavities stay. Triangles are split along
// their intersections with exact constructions, the pieces selected by winding numbers (Zhou 2016),
// and vertices rounded to double. `pairs`: selfIntersections() of the mesh. Returns nullopt if the
// pieces do not form a closed surface. Throws Cancelled. Precondition: a watertight mesh.
std::optional<WindingUnion> windingUnion(const TriangleMesh& mesh,
                                         const std::vector<std::pair<int, int>>& pairs,
                                         const base::RunContext& ctx);

// Returns the mesh with the shells that overlap united; unchanged if it does not intersect itself,
// or if the union fails or loses too much. Throws Cancelled. Precondition: a watertight mesh.
TriangleMesh overlapsUnited(TriangleMesh mesh, const base::RunContext& ctx);

} // namespace voluta::geometry
