// Spreading from the platform through the part: distances, orders, and fields without pits.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

struct Flood {
  std::vector<float> value;        // per voxel; infinite where not reached
  std::vector<std::int32_t> order; // per voxel: 0 for the first reached, -1 not reached
  std::size_t reached = 0;
};

// Priority flood (Barnes et al. 2014) from the platform over AM-stable neighbours:
//   value(v) = max(field(v), value(u) + slope * |uv|), u the neighbour it was reached from,
//   value(v) = max(field(v), slope / 2) on the platform.
// So every reached voxel is on the platform or has a neighbour that comes earlier and lies lower
// by at least slope * |uv|: no pits, no islands. With an empty field and slope 1 it is the
// chamfer distance from the platform in cells.
// `use` (empty: all) tells which voxels exist. slope >= 0. With Steps::FacesFirst only faces carry,
// edges only what no face reaches; then values may fall from one such stage to the next, the rule
// above holds all the same. Throws Cancelled.
enum class Steps { All, FacesFirst };
Flood flood(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
            const std::vector<float>& field, float slope, const base::RunContext& ctx,
            Steps steps = Steps::All);

// The chamfer distance, flood() with an empty field and slope 1, over the voxels of `among` alone:
// writes value[v] for those and leaves the rest. present[v] tells which voxels these are.
// Throws Cancelled.
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
