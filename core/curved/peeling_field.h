// The source's peeling: sheets taken off the convex front until nothing is left, whatever they
// carried (dissertation 3.4.4).
#pragma once

#include "base/run_context.h"
#include "curved/decomposition.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// F of algorithm 4 per voxel: 1 for what is peeled first, and so on without gaps. Each round takes
// all voxels whose centre lies on the boundary of the hull of the platform and what is left:
// definition 2 with the same epsilon -> 0 for which a voxel on the front may still be laid, so that
// a sheet is what growth can lay at once when the rest stands. Thicker sheets (half a cell, a cell)
// make the growth that follows them shadow more, and take the foot of a part from below. Support is
// ignored: sheets may cut a part in pieces.
//
// Growth follows the inverse field, 1 + max F - F (eq. 3.1); algorithm 4 as printed counts one more
// than the largest F there. Throws Cancelled.
std::vector<std::int32_t> peelingField(const VoxelGraph& graph, const base::RunContext& ctx);

// The same of a decomposition's part, missed voxels included and support left out, per cell of its
// grid: 0 where there is none. Precondition (Error{Internal}): one rank a cell.
std::vector<std::int32_t> peelingField(const Decomposition& decomposition,
                                       const base::RunContext& ctx);

} // namespace voluta::curved
