// Alignment of a recorded path with the planned one, in the order of both.
#pragma once

#include "record/planned_run.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::record {

// Where a recorded sample belongs on the planned path.
struct AlignedSample {
  double alongMm = 0.0;    // never decreasing
  double distanceMm = 0.0; // from the planned path there
};

struct PathAlignment {
  // Samples before `first` and from `end` on were recorded before the plan's path began, or after
  // it ended.
  std::size_t first = 0, end = 0;
  std::vector<AlignedSample> samples; // per sample from `first` to `end`
};

// Samples farther from the path than this [mm] are not of it.
inline constexpr double kNearMm = 5.0;

// Assigns each sample to a place of the planned path so that places never decrease and the sum of
// the squared distances is least (dynamic programming within a band of the path that follows the
// samples). Skipping more of the plan than the record has moved costs extra. A sample that the band
// has lost, as after a motion recorded by its two ends only, is searched in the rest of the plan.
// The record may begin or end within the plan. Returns nullopt if no sample comes within kNearMm of
// the path. Throws Cancelled.
std::optional<PathAlignment> alignRecord(const std::vector<Eigen::Vector3d>& tip,
                                         const PlannedRun& planned, const base::RunContext& ctx);

} // namespace voluta::record
