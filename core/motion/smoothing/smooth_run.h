// A run with its turns about the nozzle, and its directions within a cone, as smooth as they can be
// without meeting anything.
#pragma once

#include "motion/motion_scene.h"
#include "motion/run.h"
#include "motion/timing.h"
#include "robot/kinematics/arm_twists.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// What runs of one job are smoothed by. All that is referenced outlives it.
struct RunSmoothing {
  const MotionScene& scene;
  const robot::ArmTwists& twists;
  const TimingLimits& limits;
};

// Does something meet at those joints, on the way to that waypoint?
using Meets = std::function<bool(const robot::JointVector& q, std::size_t waypoint)>;

// Can the nozzle be lifted and travel from a run's first state, or its last?
using Lifts = std::function<bool(const RobotState& state, bool last)>;

struct SmoothedRun {
  std::vector<RunPoint> points;
  std::vector<RunPoint> before;       // what was given, divided as they are
  double smoothS = 0.0, checkS = 0.0; // wall seconds
};

// Turns of `points`, and directions within scene.options.leanRad of theirs, that make jerk least
// (smooth_turns.h) over the times of the nozzle alone, as the process wants it: what the joints
// then allow is the timing's to see to, and smooth joints allow more. A direction that is the same
// all along stays, and all do under a rod and where the arm cannot lean. Steps that come to turn so
// far that the nozzle would bend off its way are divided where directions lean. Where something
// meets (the head by what leans), an end cannot be left or steps still bend, turns and directions
// are drawn back towards what they were, and all are smoothed again, a few times; where that is not
// enough without leaning, and then the run stays as it was. Never worse: over those times the sum
// of squared jerks is at most that of `before`. Both ends keep their turn: the ladder laid them
// near the next path's. Precondition: nothing meets as `points` are. The same for any number of
// threads. Throws Cancelled.
SmoothedRun smoothRun(const RunSmoothing& by, const std::vector<RunPoint>& points,
                      const Meets& meets, const Lifts& lifts, const base::RunContext& ctx);

} // namespace voluta::motion
