// Computes the field of a part with very many voxels on a coarser grid.
#pragma once

#include "base/run_context.h"
#include "curved/field_score.h"
#include "curved/voxel_graph.h"

#include <cstddef>
#include <vector>

namespace voluta::curved {

// Maximum number of voxels of the field's grid. A finer grid adds nothing: its cells would be far
// smaller than the layer height.
inline constexpr std::size_t kFieldVoxels = 600'000;

// Returns the field per voxel [mm]: smoothField() of the coarse cells that contain a voxel of the
// graph, interpolated with its gradients to the voxels, with pits removed. The coarsening factor is
// the smallest integer for which at most kFieldVoxels / 2 cells are expected. Voxels whose coarse
// cell cannot be printed extend their neighbours' values. The plate is between two layers of coarse
// cells. Throws Cancelled.
std::vector<float> coarseField(const VoxelGraph& graph,
                               const std::vector<Eigen::Vector2d>& platform,
                               const LayerLimits& limits, int rounds,
                               const process::HeadShape* head, const base::RunContext& ctx);

} // namespace voluta::curved
