// The field from which layers are cut: alternates guided growth and refitting (docs/growth.md).
#pragma once

#include "base/run_context.h"
#include "curved/field_score.h"
#include "curved/voxel_graph.h"

#include <functional>
#include <vector>

namespace voluta::curved {

// Minimum rise of a field, per cell, from a voxel to one it supports: withoutPits() enforces it.
inline constexpr float kPitSlope = 0.15f;

struct SmoothField {
  std::vector<float> field; // mm, one per voxel: level L covers [L h, (L + 1) h)
  FieldScore score;
  std::vector<FieldScore> rounds; // of each round, in order
};

// Starts from the geodesic distance to the platform along the ranks of a growth (> 0, one per
// voxel, valid). In at most `rounds` >= 1 rounds: removes pits from the field, lets a guided
// reverse growth lower it where the front would not be reachable otherwise, and fits a smooth field
// to the result (docs/growth.md). Relaxes the overhang limit step by step while too many voxels
// stay inaccessible. Roofs may lag behind the front a little, so that layers meet them at an angle
// and each wall there rests on the previous one. If too many roofs remain and there is a `head`
// (null: a flat front), the same number of rounds follows in which roofs may lag as far as that
// head reaches past earlier material. Returns the best round by FieldScore::total(); stops early
// when one is good enough. Throws Cancelled. `improved` is called with each field that is better
// than all before, in the format of SmoothField::field.
SmoothField smoothField(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
                        const LayerLimits& limits, int rounds, const process::HeadShape* head,
                        const std::function<void(const std::vector<float>&)>& improved,
                        const base::RunContext& ctx);

} // namespace voluta::curved
