// A scheme of growth: in which order voxels are laid.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "curved/forward_growth.h"
#include "curved/voxel_graph.h"
#include "process/process.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::curved {

struct Growth {
  std::vector<std::int32_t> rank; // per voxel: n >= 1 its layer, 0 not laid
  std::int32_t ranks = 0;
  std::size_t laid = 0;
  // How deep, in cells, a voxel's centre may lie inside the hull of the platform and all lower
  // ranks: 0, or more for `relaxed` voxels.
  double epsilon = 0.0;
  std::size_t relaxed = 0;
  std::vector<Eigen::Vector3f> headDirection; // as Peeling::headDirection
  std::size_t byHead = 0;                     // voxels inside the flat front that the head reaches
  std::string scheme;     // that made it, where a row runs another one; empty: its own
  double peelSeconds = 0; // peeling, or the peeling field of guided growth
  double growSeconds = 0; // forward growth; further passes of auto and reverse
};

struct GrowthInput {
  const VoxelGraph& graph;
  const ForwardOptions& forward;  // of the sources' schemes
  const process::HeadShape* head; // null: a flat front
};

struct GrowthRow {
  std::string_view id; // as it is typed
  base::Text label;    // in plain words
  base::Text help;     // a sentence
  // Does it peel: then ForwardOptions mean nothing to it, and a field is fitted to its ranks.
  bool peels = false;
  // Fills in all but `laid`. What holds of the ranks says grow(). Throws Cancelled.
  Growth (*grow)(const GrowthInput& in, const base::RunContext& ctx) = nullptr;
};

} // namespace voluta::curved
