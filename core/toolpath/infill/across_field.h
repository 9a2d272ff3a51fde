// A function on a patch whose isolines follow a field of directions.
#pragma once

#include "base/run_context.h"
#include "toolpath/infill/infill.h"

#include <vector>

namespace voluta::toolpath {

// Returns the mean of the hatches over the vertices of a region's surface [mm].
double meanHatchMm(const InfillRegion& region);

struct AcrossField {
  std::vector<double> mm;       // per vertex: across the directions, of nearly unit gradient
  std::vector<double> gradient; // per vertex: its length; lines are that much denser
  double followed = 0.0; // mean over the area of the gradient's part across the directions, up to 1
};

// Returns the function whose gradient is, by least squares weighted by area and by how much the
// directions matter, across the region's strands in the surface. Directions that matter little, and
// places where the field has none, follow those around them (a screened Poisson equation over about
// two hatches). Signs are chosen from triangle to triangle, the clearest first. The gradient
// is longer or shorter than one where the directions diverge. Precondition: the region
// has strands. Throws Cancelled.
AcrossField acrossField(const InfillRegion& region, const base::RunContext& ctx);

} // namespace voluta::toolpath
