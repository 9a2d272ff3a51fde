// A trajectory with fewer points and none too soon after the one before, for controllers that have
// to plan each motion in time: close positions are told as errors, or stop the arm. They move the
// nozzle straight on the part. And of joint motions each that goes on as the one before: the arm
// would stop between them.
#pragma once

#include "base/run_context.h"
#include "program/program_input.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace voluta::program {

struct MergeLimits {
  double leastS = 0.0, leastMm = 0.0; // printing motions below are joined with the next; 0: none
  // What may be left out is as near to the joined motion: the tip, the nozzle's axis, and the
  // bead's section by share.
  double toleranceMm = 0.004, toleranceRad = 0.01, sectionShare = 0.02;
  double motionS = 0.0;  // what a motion takes at least: the material of a shorter one flows slower
  double jointRad = 0.0; // a joint motion that is as near to one with the next is one; 0: none is
};

struct MergedPoints {
  // The input's own, which has to outlive it, where there is nothing to join and none to slow.
  std::shared_ptr<const plan::Trajectory> trajectory;
  std::vector<std::size_t> pointOf; // per point of the input: the one there that ends its motion
};

// Leaves out points between two Print motions while the motion to the point before them is shorter
// than wanted and all that it leaves out keeps the tolerances; times and material add up. Likewise
// between joint motions on one line in joint space. Points at which anything else begins or ends
// stay. Then slows what is still too short. Throws Error{Internal} (preconditions of ProgramInput),
// Cancelled.
MergedPoints mergedPoints(const ProgramInput& input, const MergeLimits& limits,
                          const base::RunContext& ctx);

} // namespace voluta::program
