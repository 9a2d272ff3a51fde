// Plans one path of the tool plan in joints: as runs over its ladder graph (path_ladder.h) with
// smoothed rotations about the nozzle (smooth_run.h).
#pragma once

#include "motion/bead_run.h"
#include "motion/ladder/path_ladder.h"
#include "motion/motion_scene.h"
#include "motion/refusal.h"
#include "motion/smoothing/learned_clearance.h"
#include "process/tooling.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

class PathPlanner {
public:
  // `scene` must outlive the planner.
  PathPlanner(const MotionScene& scene, process::Tooling tooling)
      : scene_(scene), tooling_(std::move(tooling)), learned_(scene) {}

  // Plans waypoints [first, first + count) of path `path`, none of which the head refuses,
  // continuing from `from`. Appends the printed runs (usually one) and the refused waypoints. A run
  // starts at the last waypoint of the previous run if no waypoint is between them. The result is
  // independent of the number of threads.
  void plan(std::size_t path, std::size_t first, std::size_t count, const RobotState& from,
            const base::RunContext& ctx, std::vector<Run>& runs, std::vector<Refused>& refused);

  // Returns the times accumulated since the last call.
  PathTimes takeTimes() { return std::exchange(times_, {}); }

private:
  // Joins the last two runs if one ends where the other begins and the branch can change there.
  void joinLast(std::vector<Run>& runs) const;

  const MotionScene& scene_;
  process::Tooling tooling_;
  LearnedClearance learned_;
  PathTimes times_;
};

} // namespace voluta::motion
