// The surface of all that a closed mesh encloses, whether by one shell or by several.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <optional>
#include <utility>
#include <vector>

namespace voluta::geometry {

struct WindingUnion {
  TriangleMesh mesh;
  double insideOutMm3 = 0.0; // volume of the points with a winding number below 0, which it loses

  // Of all that was enclosed.
  double lostShare() const;
  bool losesTooMuch() const { return lostShare() > kMostLost; }

private:
  // Loops of offset surfaces are below it, lobes of a part are not: as much as may be left out of a
  // surface unasked (open_surface.h).
  static constexpr double kMostLost = 0.01;
};

// Returns the boundary of the points with a winding number of 1 or more: overlapping shells are
// united, loops of a surface that crosses itself go, cavities stay. Triangles are split along their
// intersections with exact constructions, the pieces chosen by winding numbers (Zhou 2016), and
// vertices rounded to double.
// `pairs`: selfIntersections() of the mesh.
// Returns nothing if the pieces do not make a closed surface. Throws Cancelled.
// Precondition: a watertight mesh.
std::optional<WindingUnion> windingUnion(const TriangleMesh& mesh,
                                         const std::vector<std::pair<int, int>>& pairs,
                                         const base::RunContext& ctx);

} // namespace voluta::geometry
