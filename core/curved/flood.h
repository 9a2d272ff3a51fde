// Spreading from the platform through the part: distances, orders, and fields without pits.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

struct Flood {
  std::vector<float> value;        // per voxel: chamfer distance, in cells; infinite: not reached
  std::vector<std::int32_t> order; // per voxel: 0 for the first reached, -1 not reached
  std::size_t reached = 0;
};

// From the platform, where the distance is 1/2, over AM-stable neighbours, nearest first. `use`
// (empty: all) tells which voxels exist. Throws Cancelled.
Flood flood(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
            const base::RunContext& ctx);

// Raises a field, >= 0, one a voxel, as little as takes out its pits: every voxel is on the
// platform and not lower than slope / 2, or rises by slope * |uv| or more from a neighbour u. Faces
// carry first, edges only what no face reaches (values may fall from one such stage to the next).
// What a priority flood (Barnes et al. 2014) finds; slope > 0. Infinite where not reached. Throws
// Cancelled.
std::vector<float> withoutPits(const VoxelGraph& graph, const std::vector<float>& field,
                               float slope, const base::RunContext& ctx);

// The chamfer distance of flood() over the voxels of `among` alone: writes value[v] for those and
// leaves the rest. present[v] tells which voxels these are. Throws Cancelled.
void chamferDistance(const VoxelGraph& graph, const std::vector<std::int32_t>& among,
                     const std::vector<std::uint8_t>& present, std::vector<float>& value,
                     const base::RunContext& ctx);

// Geodesic distance from the platform inside the part, in cells (first order fast marching over
// the faces of cells; Sethian 1996). A voxel on the platform has 1/2. Voxels that hang together
// only by an edge get the distance of that neighbour plus sqrt(2). Infinite where not reached.
// With ranks (empty: none) only along ways on which they never fall: loops then close where that
// growth closed them.
std::vector<float> geodesicDistance(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
                                    const base::RunContext& ctx);

} // namespace voluta::curved
