// The order in which the voxels of a proposed layer are tried (list Q of the sources).
#pragma once

#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// Returns the layer's voxels by distance from its first one along the AM-stable neighbours within
// the layer (Dijkstra; dissertation 3.4.3, which starts from a random voxel instead). Pieces not
// reached this way follow, each from its own first voxel.
std::vector<std::int32_t> floodingOrder(const VoxelGraph& graph,
                                        const std::vector<std::int32_t>& layer);

// Returns the layer's voxels in the order in which repeated halving along the longest principal
// axis reaches single voxels (dissertation 3.4.3, recursive shadow-free sets).
std::vector<std::int32_t> halvingOrder(const VoxelGraph& graph,
                                       const std::vector<std::int32_t>& layer);

} // namespace voluta::curved
