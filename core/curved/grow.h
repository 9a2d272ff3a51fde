// The order of the voxels alone: any growth scheme, before there is a field.
#pragma once

#include "base/run_context.h"
#include "curved/growth_row.h"
#include "curved/growth_scheme.h"

namespace voluta::curved {

// Both constraints of dissertation 3.3.1 hold between voxel centres for all that is laid: a voxel
// stands on the platform or has an AM-stable neighbour of lower rank, and does not lie deeper than
// epsilon inside the convex hull of the platform and all lower ranks.
//
// `head` (null: a flat front): where peeling would have to give voxels up, those that this head
// reaches past all that is laid before them are laid all the same. Throws Cancelled.
Growth grow(const VoxelGraph& graph, const GrowthScheme& scheme, const ForwardOptions& forward,
            const base::RunContext& ctx, const process::HeadShape* head = nullptr);

} // namespace voluta::curved
