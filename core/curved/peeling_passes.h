// Growth by peeling in several passes.
#pragma once

#include "base/run_context.h"
#include "curved/growth_row.h"

namespace voluta::curved {

// Peels (reverse_growth.h) with sheets of 0.6 cells. Returns that result if it prints every voxel
// reachable from the platform, or all but 0.01 % of more than 200,000. Otherwise runs two further
// passes (sheets of 0.6 and 1 cell, with the tolerance of half a cell for whole sheets where
// peeling is stuck), including restarts, and returns the better one: fewest missed, then fewest
// relaxed voxels, then fewest layers. The choice of the order does not affect the evenness of the
// field, which is computed from distances and not from ranks.
//
// With a head: where peeling would have to give up voxels, those that the head reaches past all
// earlier material are printed nevertheless. Throws Cancelled.
Growth growByPeeling(const GrowthInput& in, const base::RunContext& ctx);

} // namespace voluta::curved
