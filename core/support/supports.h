// Supports for what growth misses: thin columns, as few as can be, grown with the part
// (dissertation 3.4, fig. 3.17c).
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "curved/grow.h"
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

// supports (none, auto).
base::ParameterTable supportParameters();
bool supportsWanted(const base::ParameterValues& values);

struct SupportOptions {
  curved::GrowthScheme growth;
  curved::ForwardOptions forward;
  process::HeadShape head; // as CurvedOptions::head; empty: a flat front
  double bridgeMm = 6.0;   // what a bead spans with nothing beneath: arms are half as long at most
  int rounds = 10;         // of growth and new columns, at most
  int trials = 12;         // columns left out by way of trial, at most
};

struct Supports {
  voxel::SolidVoxels solid;                      // part and support together, on the part's grid
  std::vector<std::uint8_t> support;             // per cell: 1 where support is; empty: none needed
  std::vector<Column> columns;                   // disjoint; together the support
  std::size_t voxels = 0;                        // of support
  std::size_t missedBefore = 0, missedAfter = 0; // voxels of the part
  std::size_t unreachedBefore = 0;               // of them: no way through the part
  std::shared_ptr<const curved::Growth> growth;  // of `solid`; null: not grown
  plan::Findings findings; // what is carried (not blocking); what no column reaches (blocking)
  int growths = 0;         // how often something was grown
  double seconds = 0.0;
};

// Where curved::grow() misses voxels of `part`: a column one cell wide (cheapestColumn) under every
// group that growth has to give up, from inside the platform or from a part of the part that lies
// nearer to the platform; grown again with them, until nothing is missed or no further column can
// be found; then every column that is not needed after all is taken away again. Where growth
// misses nothing, that is all it does. The sources' schemes take long: four rounds at most, and
// nothing is taken away.
// Growing `solid` by the same scheme misses `missedAfter` voxels of the part.
// `platform`: as in curved::voxelGraph(). Throws Cancelled.
Supports supportsFor(const voxel::SolidVoxels& part, const std::vector<Eigen::Vector2d>& platform,
                     const SupportOptions& options, const base::RunContext& ctx);

} // namespace voluta::support
