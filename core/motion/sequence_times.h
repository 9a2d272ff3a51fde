// Times of runs and of the transfers between them, and the jerk of their joints.
#pragma once

#include "motion/jerk.h"
#include "motion/motion_scene.h"
#include "motion/sequence.h"
#include "process/tooling.h"

#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// Of one run or transfer.
struct TimedPiece {
  std::vector<double> times; // [s] from 0, one per point; a transfer's first point is its start
  JerkMeasure jerk;
  double slowedS = 0.0; // by which the limit of the jerk makes it longer
};

struct TimedSequence {
  std::vector<TimedPiece> runs, ways; // as those of the sequence
  std::vector<JerkMeasure> ladder;    // jerk of each run with the ladder's rotations, same times
};

// Returns the times within all limits of cell, process and options (maxJerk, if positive). From
// home, to home and between two tools the first tool's process counts. The arm stops for each step
// of a tool change. Precondition: a way to each run. The result does not depend on the number of
// threads. Throws Cancelled.
TimedSequence timesOfSequence(const Sequence& sequence, const MotionScene& scene,
                              const process::Tooling& tooling, const RobotState& home,
                              const base::RunContext& ctx);

} // namespace voluta::motion
