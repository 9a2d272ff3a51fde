// The field that layers are cut from: alternating guided growth and refit (docs/growth.md).
#pragma once

#include "base/run_context.h"
#include "curved/field_score.h"
#include "curved/voxel_graph.h"

#include <functional>
#include <vector>

namespace voluta::curved {

// Least rise of a field, per cell, from a voxel to one it carries: withoutPits() takes out what is
// less.
inline constexpr float kPitSlope = 0.15f;

struct SmoothField {
  std::vector<float> field; // mm, one a voxel: level L covers [L h, (L + 1) h)
  FieldScore score;
  std::vector<FieldScore> rounds; // of each round, in order
};

// From the geodesic distance to the platform along the ranks of a growth (> 0, one a voxel, valid),
// `rounds` >= 1 times at most: take pits out of the field, let a guided reverse growth lower it
// where the front could not be reached otherwise, fit a smooth field to that (docs/growth.md).
// Overhang is given way to step by step while too much stays inaccessible. Roofs may lag behind the
// front a little, so that layers meet them at an angle and each wall there lies on the one before.
// Where too many roofs are left all the same and there is a `head` (null: a flat front), as many
// rounds follow in which they may lag as far as that head reaches past what is laid before them.
// Keeps the best round by FieldScore::total(); ends early when one is good enough. Throws
// Cancelled. `improved` hears of each field that is better than those before, as
// SmoothField::field.
SmoothField smoothField(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
                        const LayerLimits& limits, int rounds, const process::HeadShape* head,
                        const std::function<void(const std::vector<float>&)>& improved,
                        const base::RunContext& ctx);

} // namespace voluta::curved
