// The order of the voxels alone: any growth scheme, before there is a field.
#pragma once

#include "base/run_context.h"
#include "curved/forward_growth.h"
#include "curved/voxel_graph.h"
#include "process/process.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voluta::curved {

// Schemes that a user may name, in the order they are offered: auto, reverse, guided, adaptive,
// incremental, greedy. The last four are the sources' (forward_growth.h).
std::vector<std::string> growthSchemes();
// Whether a scheme peels: auto and reverse. The others grow forward.
bool peels(const std::string& scheme);
// Throws Error{Usage} that names the nearest scheme.
void checkGrowthScheme(const std::string& scheme);

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
  std::string scheme;                         // that made it: never auto
  double peelSeconds = 0;                     // peeling, or the peeling field of guided growth
  double growSeconds = 0;                     // forward growth; further passes of auto and reverse
};

// Both constraints of dissertation 3.3.1 hold between voxel centres for all that is laid: a voxel
// stands on the platform or has an AM-stable neighbour of lower rank, and does not lie deeper than
// epsilon inside the convex hull of the platform and all lower ranks.
//
// `auto` and `reverse` peel (reverse_growth.h) with sheets of 0.6 cells. When that lays every voxel
// the platform reaches, it is the answer, or all but 0.01 % of more than 200,000; otherwise two
// further passes (sheets of 0.6 and 1 cell, the tolerance of half a cell for whole sheets where
// nothing else can go on) are run, restarts included, and the best is kept: fewest missed, then
// fewest relaxed, then fewest layers. Which order it is does not matter to the evenness of the
// field, as that starts from distances and not from ranks.
//
// `head` (null: a flat front): where peeling would have to give voxels up, those that this head
// reaches past all that is laid before them are laid all the same.
//
// Throws Error{Usage} for an unknown scheme; Cancelled.
Growth grow(const VoxelGraph& graph, const std::string& scheme, const ForwardOptions& forward,
            const base::RunContext& ctx, const process::HeadShape* head = nullptr);

} // namespace voluta::curved
