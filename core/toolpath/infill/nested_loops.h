// Loops at equal distances from the boundary of a region, and which of them are neighbours.
#pragma once

#include "base/run_context.h"
#include "toolpath/infill/infill.h"
#include "toolpath/patch_surface.h"

#include <array>
#include <vector>

namespace voluta::toolpath {

inline constexpr int kNoBand = -1;

struct NestedLoop {
  SurfaceCurve curve; // Closed; the deeper side is to its left, seen against the triangles' normals
  // Bands on its outer and on its inner side; kNoBand outside the outermost loops.
  std::array<int, 2> band{kNoBand, kNoBand};
};

// The loops cut the region into bands. A band with two loops lies between neighbours; one with more
// is where the region branches or where fronts from an outline and from holes meet; one with a
// single loop is the middle of a pocket.
struct NestedLoops {
  std::vector<NestedLoop> loops;
  std::vector<std::vector<int>> ofBand; // Loops per band
  std::vector<SurfaceCurve> open;       // Walls that are no loops: none on a closed boundary
  std::vector<int> rank;                // Per vertex: number of the loops around it
};

// Returns the walls (walls.h) at half a spacing from the region's edge, one and a half, and so on,
// with one hatch per density as spacing. Throws Cancelled.
NestedLoops nestedLoops(const InfillRegion& region, const base::RunContext& ctx);

} // namespace voluta::toolpath
