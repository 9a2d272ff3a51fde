// A growth scheme: computes the order in which voxels are printed.
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
  std::vector<std::int32_t> rank; // Per voxel: layer n >= 1; 0: not printed
  std::int32_t ranks = 0;
  std::size_t printed = 0;
  // Maximum depth [cells] of a voxel's centre inside the hull of the platform and all lower ranks:
  // 0, or more for `relaxed` voxels.
  double epsilon = 0.0;
  std::size_t relaxed = 0;
  std::vector<Eigen::Vector3f> headDirection; // As Peeling::headDirection
  std::size_t byHead = 0;                     // Voxels inside the flat front that the head reaches
  // The scheme that produced it, if a row runs another one; empty: the row's scheme
  std::string scheme;
  double peelSeconds = 0; // Peeling, or the peeling field of guided growth
  double growSeconds = 0; // Forward growth; further passes of auto and reverse
};

struct GrowthInput {
  const VoxelGraph& graph;
  const ForwardOptions& forward;  // For the sources' schemes
  const process::HeadShape* head; // Null: a flat front
};

struct GrowthRow {
  std::string_view id; // As typed by users
  base::Text label;
  base::Text help; // One sentence
  // Whether the scheme peels: it then ignores ForwardOptions, and a field is fitted to its ranks.
  bool peels = false;
  // Fills in all members but `printed`. grow() documents the properties of the ranks. Throws
  // Cancelled.
  Growth (*grow)(const GrowthInput& in, const base::RunContext& ctx) = nullptr;
};

} // namespace voluta::curved
