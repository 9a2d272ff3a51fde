// How much hangs on a single voxel: articulation points of the part's graph.
#pragma once

#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// Per voxel: how many other present voxels lose every way to the platform when it goes (0 for
// most). One depth-first search from a root that stands for the platform (Hopcroft and Tarjan
// 1973).
std::vector<std::int32_t> lossWithout(const VoxelGraph& graph,
                                      const std::vector<std::uint8_t>& present);

} // namespace voluta::curved
