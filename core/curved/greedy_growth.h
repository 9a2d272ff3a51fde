// Forward growth as the source's plain scheme does it: it may lose voxels.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

struct GreedyGrowth {
  std::vector<std::int32_t> rank; // per voxel: 1 stands on the platform; 0: never laid
  std::int32_t ranks = 0;
};

// Algorithm 1 (GreedyGrowingCFA, dissertation 3.4.2): the next layer is all AM-stable neighbours
// of the current one that are not laid and not inside the convex front; "inside" is strict, so a
// centre on the front may still be laid (definition 3 with epsilon = 0). Throws Cancelled.
GreedyGrowth greedyGrowth(const VoxelGraph& graph, const base::RunContext& ctx);

} // namespace voluta::curved
