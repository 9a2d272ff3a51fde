// The print order of the voxels by any growth scheme, before a field is computed.
#pragma once

#include "base/run_context.h"
#include "curved/growth_row.h"
#include "curved/growth_scheme.h"

namespace voluta::curved {

// Returns the growth. Both constraints of dissertation 3.3.1 hold between centres of printed
// voxels: a voxel is on the platform or has an AM-stable neighbour of lower rank, and is not deeper
// than epsilon inside the convex hull of the platform and all lower ranks.
//
// `head` (null: a flat front): where peeling would have to give up voxels, those that this head
// reaches past all earlier voxels are printed anyway. Throws Cancelled.
Growth grow(const VoxelGraph& graph, const GrowthScheme& scheme, const ForwardOptions& forward,
            const base::RunContext& ctx, const process::HeadShape* head = nullptr);

} // namespace voluta::curved
