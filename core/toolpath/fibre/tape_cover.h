// Area of a patch under tapes.
#pragma once

#include "base/run_context.h"
#include "toolpath/patch_surface.h"

#include <span>

namespace voluta::toolpath {

using TapeSet = std::span<const SurfaceCurve>;

// mm2
struct TapeCover {
  double regionMm2 = 0.0;  // under any of the sets
  double coveredMm2 = 0.0; // of that, under the chosen tapes
  double overlapMm2 = 0.0; // of that, under two of them or more
};

// Returns the area under tapes of that width with square ends; to about a triangle's size at their
// edges. Throws Cancelled.
TapeCover coverOf(const PatchSurface& surface, TapeSet chosen, std::span<const TapeSet> sets,
                  double widthMm, const base::RunContext& ctx);

} // namespace voluta::toolpath
