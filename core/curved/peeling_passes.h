// Growth by peeling, in as many passes as are worth it.
#pragma once

#include "base/run_context.h"
#include "curved/growth_row.h"

namespace voluta::curved {

// Peels (reverse_growth.h) with sheets of 0.6 cells. When that lays every voxel the platform
// reaches, it is the answer, or all but 0.01 % of more than 200,000; otherwise two further passes
// (sheets of 0.6 and 1 cell, the tolerance of half a cell for whole sheets where nothing else can
// go on) are run, restarts included, and the best is kept: fewest missed, then fewest relaxed, then
// fewest layers. Which order it is does not matter to the evenness of the field, as that starts
// from distances and not from ranks.
//
// With a head: where peeling would have to give voxels up, those that this head reaches past all
// that is laid before them are laid all the same. Throws Cancelled.
Growth growByPeeling(const GrowthInput& in, const base::RunContext& ctx);

} // namespace voluta::curved
