// Supports for voxels that growth misses: as few thin columns as possible, grown with the part
// (dissertation 3.4, fig. 3.17c).
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "curved/grow.h"
#include "layers/support_places.h"
#include "plan/finding.h"
#include "process/process.h"
#include "support/columns.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voluta::support {

// Returns the parameter supports (none, auto, always).
base::ParameterTable supportParameters();
layers::SupportRule supportRule(const base::ParameterValues& values);
// Returns whether supports are wanted outside of regions.
bool supportsWanted(const base::ParameterValues& values);

struct SupportOptions {
  curved::GrowthScheme growth;
  curved::ForwardOptions forward;
  process::HeadShape head; // as CurvedOptions::head; empty: a flat front
  double bridgeMm = 6.0;   // maximum unsupported length of a bead; arms are at most half as long
  int rounds = 10;         // of growth and new columns, at most
  int trials = 12;         // trial removals of columns, at most
  // Of each cell; empty: Auto for all. Voxels of a region with None are not carried; below voxels
  // with Always, where the part ends, columns stand at most bridgeMm apart and stay.
  std::vector<layers::SupportRule> rules = {};
  std::vector<std::uint8_t> closed = {}; // per cell: 1 if no column may use it; empty: none
};

struct Supports {
  voxel::SolidVoxels solid;                      // part and support together, on the part's grid
  std::vector<std::uint8_t> support;             // per cell: 1 if support; empty: none needed
  std::vector<Column> columns;                   // disjoint; together the support
  std::size_t voxels = 0;                        // of support
  std::size_t missedBefore = 0, missedAfter = 0; // voxels of the part
  std::size_t unreachedBefore = 0; // those of missedBefore without a connection through the part
  std::shared_ptr<const curved::Growth> growth; // of `solid`; null: not grown
  // Carried voxels (not blocking), voxels that no column reaches (blocking)
  plan::Findings findings;
  int growths = 0; // number of growths computed
  double seconds = 0.0;
};

// If curved::grow() misses voxels of `part`, puts a column one cell wide (cheapestColumn) below
// every group that growth has to abandon, based on the platform or on a section of the part that is
// nearer to the platform, and grows again, until nothing is missed or no further column is found;
// then removes every column that is not needed. If growth misses nothing, does nothing else. For
// the published schemes, which are slow, does four rounds at most and removes nothing. Columns that
// the rules ask for are put before all others, whether growth misses anything or not. Growing
// `solid` by the same scheme misses `missedAfter` voxels of the part. `platform`: as in
// curved::voxelGraph(). Throws Cancelled.
Supports supportsFor(const voxel::SolidVoxels& part, const std::vector<Eigen::Vector2d>& platform,
                     const SupportOptions& options, const base::RunContext& ctx);

} // namespace voluta::support
