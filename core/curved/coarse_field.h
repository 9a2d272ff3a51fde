// The field of a part with very many voxels, found on a coarser grid.
#pragma once

#include "base/run_context.h"
#include "curved/field_score.h"
#include "curved/voxel_graph.h"

#include <cstddef>
#include <vector>

namespace voluta::curved {

// Above this many voxels a finer field tells nothing more: its cells would be far smaller than a
// layer is high.
inline constexpr std::size_t kFieldVoxels = 600'000;

// smoothField() of the cells of a grid `factor` times as coarse that hold a voxel of the graph,
// interpolated with its gradients to the voxels, pits taken out: mm, one a voxel. The factor is the
// least whole number with which no more than kFieldVoxels / 2 cells are expected. Voxels whose
// coarse cell cannot be laid continue their neighbours. The plate stays between two layers of
// cells. Throws Cancelled.
std::vector<float> coarseField(const VoxelGraph& graph,
                               const std::vector<Eigen::Vector2d>& platform,
                               const LayerLimits& limits, int rounds,
                               const process::HeadShape* head, const base::RunContext& ctx);

} // namespace voluta::curved
