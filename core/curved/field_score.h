// Printability score of a field, used to compare the iterations of the smooth field.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"
#include "process/process.h"

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace voluta::curved {

struct LayerLimits {
  double heightMm = 0.8, minMm = 0.4, maxMm = 1.0; // Nominal, minimum and maximum thickness
};

struct FieldScore {
  double scale = 1.0;  // Levels = scale * field makes best use of the limits
  double within = 0.0; // Share of the voxels whose thickness is within the limits
  // Share of the voxels more than half a cell inside the hull of all earlier levels that the head
  // does not reach either
  double inaccessible = 0.0;
  double deepest = 0.0;  // Maximum depth of these voxels [cells]
  double overhang = 0.0; // Share of the surface that overhangs by more than 60 degrees
  double roofs = 0.0;    // The same voxels as a share of all voxels
  // Returns the weighted score; smaller is better. Thickness and inaccessibility count fully beyond
  // the margins of the process, otherwise only enough to rank good fields. Voxels outside the
  // thickness limits must be cut or filled, inaccessible voxels are gouged by a flat head, while
  // overhangs only affect appearance.
  double total() const {
    return 2.0 * std::max(0.0, 0.9965 - within) + 4.0 * std::max(0.0, inaccessible - 0.0012) +
           0.01 * std::max(0.0, deepest - 1.4) + 0.3 * overhang +
           0.1 * (1.0 - within + inaccessible);
  }
};

// Returns the factor by which levels should be closer (> 1) or wider (< 1) than the field in cells
// indicates. The median thickness is as close as possible to the nominal height, but not above it,
// and at most 0.1 % of the voxels are outside the limits that another factor would keep within
// them. `slope` is |grad field| per voxel. The level of a voxel in mm is scale * field * pitch.
double bestScale(const std::vector<float>& slope, const LayerLimits& limits, double* within);

// Computes the score and fills `deep` with the inaccessible voxels more than one cell inside the
// hull. `head`: voxels inside the hull that this head reaches past all earlier levels count as
// accessible; null: none do.
FieldScore scoreField(const VoxelGraph& graph, const std::vector<float>& field,
                      const std::vector<Eigen::Vector3f>& normals, const LayerLimits& limits,
                      const process::HeadShape* head, std::vector<std::int32_t>& deep,
                      const base::RunContext& ctx);

} // namespace voluta::curved
