// One path of the tool plan in joints: runs over its ladder graph (path_ladder.h), their turns
// about the nozzle made smooth (smooth_run.h).
#pragma once

#include "motion/ladder/path_ladder.h"
#include "motion/motion_scene.h"
#include "motion/refusal.h"
#include "motion/run.h"
#include "motion/timing.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

class PathPlanner {
public:
  PathPlanner(const MotionScene& scene, TimingLimits limits)
      : scene_(scene), limits_(std::move(limits)) {}

  // Plans waypoints [first, first + count) of path `path`, none of which the head refuses, to
  // follow on `from`. Appends the runs that are printed (usually one) and the waypoints that are
  // not. Each run's first waypoint is the last one's of the run before where no waypoint lies
  // between them. The same for any number of threads.
  void plan(std::size_t path, std::size_t first, std::size_t count, const RobotState& from,
            const base::RunContext& ctx, std::vector<Run>& runs, std::vector<Refused>& refused);

  // Since it was last asked.
  PathTimes takeTimes() { return std::exchange(times_, {}); }

private:
  const MotionScene& scene_;
  TimingLimits limits_;
  PathTimes times_;
};

} // namespace voluta::motion
