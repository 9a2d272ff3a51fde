// The field that layers are cut from: alternating guided growth and refit (growth.md).
#pragma once

#include "base/run_context.h"
#include "curved/field_score.h"
#include "curved/voxel_graph.h"

#include <vector>

namespace voluta::curved {

struct SmoothField {
  std::vector<float> field; // mm, one a voxel: level L covers [L h, (L + 1) h)
  FieldScore score;
  std::vector<FieldScore> rounds; // of each round, in order
  double growSeconds = 0.0, smoothSeconds = 0.0;
};

// From the geodesic distance to the platform, `rounds` >= 1 times: take pits out of the field,
// let a guided reverse growth lower it where the front could not be reached otherwise, fit a
// smooth field to that. Keeps the best round by FieldScore::total(). Every voxel of the graph must
// be reached from the platform (Error{Internal}). Throws Cancelled.
SmoothField smoothField(const VoxelGraph& graph, const LayerLimits& limits, int rounds,
                        const base::RunContext& ctx);

} // namespace voluta::curved
