// Merging of a trajectory's points and slowing of short motions, for controllers that must plan
// each motion in time: points too close to each other raise errors or stop the arm. Merged printing
// motions are straight on the part. Joint motions that continue the preceding one are merged as
// well, since the arm would stop between them.
#pragma once

#include "base/run_context.h"
#include "program/program_input.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace voluta::program {

struct MergeLimits {
  double leastS = 0.0, leastMm = 0.0; // shorter printing motions are merged with the next; 0: none
  // Tolerances between omitted points and the merged motion: position of the tip, nozzle axis, and
  // relative bead section.
  double toleranceMm = 0.004, toleranceRad = 0.01, sectionShare = 0.02;
  double motionS = 0.0;  // minimum duration of a motion; shorter ones are slowed, with less flow
  double jointRad = 0.0; // tolerance for merging a joint motion with the next; 0: no merging
};

struct MergedPoints {
  // The input's own trajectory, which must outlive this, if there is nothing to merge or slow.
  std::shared_ptr<const plan::Trajectory> trajectory;
  std::vector<std::size_t> pointOf; // per point of the input: the merged point that ends its motion
};

// Omits points between two Print motions while the motion to the preceding point is shorter than
// wanted and all omitted points are within the tolerances; times and material are summed. Also
// merges joint motions along one line in joint space. Points at which anything else begins or ends
// are kept. Then slows motions that are still too short. Throws Error{Internal} (preconditions of
// ProgramInput), Cancelled.
MergedPoints mergedPoints(const ProgramInput& input, const MergeLimits& limits,
                          const base::RunContext& ctx);

} // namespace voluta::program
