// The peeling field of the source: removes sheets from the convex front until nothing is left,
// regardless of support (dissertation 3.4.4).
#pragma once

#include "base/run_context.h"
#include "curved/decomposition.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// Returns F of algorithm 4 per voxel: 1 for voxels peeled first, and so on without gaps. Each round
// removes all voxels whose centre is on the boundary of the hull of the platform and the remaining
// voxels. This is definition 2 with the same epsilon -> 0 for which a voxel on the front may still
// be printed, so that a sheet is the set that growth can print at once on the remainder. Thicker
// sheets (half a cell, a cell) would make the subsequent growth shadow more and remove the foot of
// a part from below. Support is ignored: sheets may cut a part in pieces.
//
// Growth follows the inverse field, 1 + max F - F (eq. 3.1); algorithm 4 as printed counts one more
// than the largest F there. Throws Cancelled.
std::vector<std::int32_t> peelingField(const VoxelGraph& graph, const base::RunContext& ctx);

// As above for the part of a decomposition, including missed voxels and excluding support, per cell
// of its grid: 0 outside. Precondition (Error{Internal}): one rank per cell.
std::vector<std::int32_t> peelingField(const Decomposition& decomposition,
                                       const base::RunContext& ctx);

} // namespace voluta::curved
