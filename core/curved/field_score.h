// How well a field would print: what the rounds of the smooth field are compared by.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"
#include "process/process.h"

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace voluta::curved {

struct LayerLimits {
  double heightMm = 0.8, minMm = 0.4, maxMm = 1.0; // nominal, least and largest thickness
};

struct FieldScore {
  double scale = 1.0;        // levels = scale * field: best use of the limits
  double within = 0.0;       // share of the voxels whose thickness is within the limits
  double inaccessible = 0.0; // share deeper than half a cell inside all earlier levels' hull, that
                             // the head does not reach there either
  double deepest = 0.0;      // of those, cells
  double overhang = 0.0;     // share of the surface that leans over by more than 60 degrees
  double roofs = 0.0;        // the same voxels as a share of all
  // Smaller is better. What passes a margin of the process counts fully, the rest as far as it
  // tells good fields apart: thickness out of limits must be cut or filled, what lies inside the
  // front is gouged by a flat head, what leans over only looks worse.
  double total() const {
    return 2.0 * std::max(0.0, 0.9965 - within) + 4.0 * std::max(0.0, inaccessible - 0.0012) +
           0.01 * std::max(0.0, deepest - 1.4) + 0.3 * overhang +
           0.1 * (1.0 - within + inaccessible);
  }
};

// The factor by which levels should be closer (> 1) or wider (< 1) than the field in cells says:
// the median thickness as near to the nominal height as can be, not above it, with no more than
// 0.1 % of the voxels outside the limits that another factor would keep inside. `slope` is |grad
// field| a voxel. level of a voxel in mm is scale * field * pitch.
double bestScale(const std::vector<float>& slope, const LayerLimits& limits, double* within);

// Fills `deep` with the inaccessible voxels that lie deeper than one cell inside that hull. `head`:
// of what lies inside, what this head reaches past all earlier levels is accessible; null: none is.
FieldScore scoreField(const VoxelGraph& graph, const std::vector<float>& field,
                      const std::vector<Eigen::Vector3f>& normals, const LayerLimits& limits,
                      const process::HeadShape* head, std::vector<std::int32_t>& deep,
                      const base::RunContext& ctx);

} // namespace voluta::curved
