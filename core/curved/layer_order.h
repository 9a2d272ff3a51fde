// In which order the voxels of a proposed layer are tried (list Q of the sources).
#pragma once

#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// By distance from the layer's first voxel along the AM-stable neighbours within the layer
// (Dijkstra; dissertation 3.4.3, which starts from a random voxel instead). Pieces that this does
// not reach follow, each from its own first voxel.
std::vector<std::int32_t> floodingOrder(const VoxelGraph& graph,
                                        const std::vector<std::int32_t>& layer);

// The order in which halving along the longest principal axis, again and again, comes to single
// voxels (dissertation 3.4.3, recursive shadow-free sets).
std::vector<std::int32_t> halvingOrder(const VoxelGraph& graph,
                                       const std::vector<std::int32_t>& layer);

} // namespace voluta::curved
