// Floods from the platform through the part: distances, orders, and fields without pits.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

struct Flood {
  std::vector<float> value;        // Per voxel: chamfer distance [cells]; infinite if not reached
  std::vector<std::int32_t> order; // Per voxel: 0 for the first one reached, -1 if not reached
  std::size_t reached = 0;
};

// Floods from the platform, where the distance is 1/2, over AM-stable neighbours, nearest first.
// `use` marks the existing voxels (empty: all). Throws Cancelled.
Flood flood(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
            const base::RunContext& ctx);

// Removes the pits of a field (>= 0, one value per voxel) by raising it as little as possible:
// every voxel is on the platform and not lower than slope / 2, or rises by slope * |uv| or more
// from a neighbour u. Faces are used first, edges only for voxels that no face reaches (values may
// fall from one such stage to the next). The result is that of a priority flood (Barnes et al.
// 2014); slope > 0. Infinite where not reached. Throws Cancelled.
std::vector<float> withoutPits(const VoxelGraph& graph, const std::vector<float>& field,
                               float slope, const base::RunContext& ctx);

// Computes the chamfer distance of flood() over the voxels of `among` alone: writes value[v] for
// those and leaves the rest. present[v] marks these voxels. Throws Cancelled.
void chamferDistance(const VoxelGraph& graph, const std::vector<std::int32_t>& among,
                     const std::vector<std::uint8_t>& present, std::vector<float>& value,
                     const base::RunContext& ctx);

// Returns the geodesic distance from the platform inside the part [cells] (first-order fast
// marching over the faces of cells; Sethian 1996). A voxel on the platform has 1/2. Voxels
// connected only by an edge get the distance of that neighbour plus sqrt(2). Infinite where not
// reached. With ranks (empty: none), only along paths on which the ranks never fall: loops then
// close where that growth closed them.
std::vector<float> geodesicDistance(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
                                    const base::RunContext& ctx);

} // namespace voluta::curved
