// Smooths a run's rotations about the nozzle, and its directions within a cone, as far as possible
// without collisions.
#pragma once

#include "motion/bead_run.h"
#include "motion/motion_scene.h"
#include "motion/timing.h"
#include "robot/kinematics/arm_twists.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

struct Nearness;

// Inputs for smoothing all runs of one job. All references must outlive it.
struct RunSmoothing {
  const MotionScene& scene;
  const robot::ArmTwists& twists;
  const TimingLimits& limits;
  const Nearness* nearness = nullptr; // estimated collisions that smoothing avoids; null: none
};

// Returns whether these joints collide on the way to that waypoint.
using Meets = std::function<bool(const robot::JointVector& q, std::size_t waypoint)>;

// Returns whether the nozzle can be lifted and travel from a run's first state, or its last.
using Lifts = std::function<bool(const RobotState& state, bool last)>;

struct SmoothedRun {
  std::vector<RunPoint> points;
  std::vector<RunPoint> before;       // The input run, divided in the same way
  double smoothS = 0.0, checkS = 0.0; // Wall-clock times [s]
};

// Returns the run with those rotations of `points`, and directions within scene.options.leanRad of
// theirs, that minimise jerk (smooth_turns.h) over the times of the nozzle alone, as the process
// requires. The timing applies the joint limits later; smooth joints allow more speed. A constant
// direction is kept, and all directions are kept under a rod and where the arm cannot lean.
//
// If directions lean, steps that rotate so far that the nozzle would deviate from its path are
// divided. If there are collisions (also of the head where directions lean), an end cannot be left
// or steps still deviate, rotations and directions are pulled back towards their original values,
// and all are smoothed again, a few times. If that does not suffice, the run is smoothed without
// leaning; if that fails too, it stays unchanged. Never worse: over those times the sum of squared
// jerks is at most that of `before`. Both ends nearly keep their rotation, which the ladder chose
// near the next path's.
//
// Precondition: `points` are collision-free. The result does not depend on the number of threads.
// Throws Cancelled.
SmoothedRun smoothRun(const RunSmoothing& by, const std::vector<RunPoint>& points,
                      const Meets& meets, const Lifts& lifts, const base::RunContext& ctx);

} // namespace voluta::motion
