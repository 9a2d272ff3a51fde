// Plans a robot's motion from beads: a ladder graph per path, transfers, timing, checks.
#pragma once

#include "motion/too_large.h"
#include "plan/finding.h"
#include "plan/statistics.h"
#include "plan/trajectory.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::collision {
class GrowingPart;
}
namespace voluta::plan {
struct ToolPlan;
}
namespace voluta::process {
class Tooling;
}
namespace voluta::robot {
class Cell;
}

namespace voluta::motion {

struct MotionOptions;

inline constexpr double kClearanceCapMm = 100.0;

// Wall-clock times [s], disjoint.
struct MotionTimes {
  double ik = 0.0, graph = 0.0, jerk = 0.0, collision = 0.0, transfer = 0.0;
};

struct MotionResult {
  bool isGivenUp = false; // The result contains findings only
  plan::Trajectory trajectory;
  std::vector<std::size_t> skipped; // Waypoints that are not printed, ascending
  plan::Findings findings;
  std::optional<TooLarge> tooLarge; // To be reported before the findings
  plan::MotionStatistics statistics;
  MotionTimes times;
};

// Plans the whole program: home, to the first path, all paths with transfers between them, home.
// Waypoints that cannot be reached or would collide are left out, reported in findings and listed
// in skipped; the paths are printed without them. If the finished motion collides in the closer
// check, which includes places between points, it is planned again without the waypoints concerned.
// If at most half a percent of the material is left out, this is reported and does not block.
//
// Print points carry the waypoint's index, or none where a step was divided; a run's first point is
// reached by a Linear (or Joint) move and carries its waypoint too. Where a path had to be split,
// the waypoint at the split appears at the end of one run and again at the start of the next.
// A shot moves like a transfer; its material is that of its event.
// extrudedMm3 increases at Print points only, by the mean of the sections at both waypoints times
// their distance. A rod is at a multiple of its step at every point; if it can turn endlessly, it
// ends at a whole turn. The result does not depend on the number of threads.
//
// Example:
//   const double pitch = collision::growingPitch(toolPlan, tooling);
//   const collision::GrowingPart growing(toolPlan, pitch, ctx);
//   motion::MotionOptions options;
//   options.purge.primesBeside = true;
//   motion::MotionPlanner planner(toolPlan, cell, tooling, growing, options);
//   const motion::MotionResult moved = planner.plan(ctx);
class MotionPlanner {
public:
  // All arguments but the tooling must outlive the planner. Preconditions: part was grown from
  // `plan`; the process of the first tool is the cell's.
  MotionPlanner(const plan::ToolPlan& plan, const robot::Cell& cell,
                const process::Tooling& tooling, const collision::GrowingPart& part,
                const MotionOptions& options);
  ~MotionPlanner();

  // Stops as soon as more than `maxLeftOut` of the material is known to be unprintable. Throws
  // Cancelled. In both cases the planner cannot be used any further.
  MotionResult plan(const base::RunContext& ctx, double maxLeftOut = 1.0);
  // After plan: plans again without these waypoints and those of earlier calls, because collisions
  // were found there. Only the paths that contain them are planned again. Throws Cancelled.
  MotionResult planWithout(const std::vector<std::size_t>& waypoints, const base::RunContext& ctx);

private:
  class Work;
  std::unique_ptr<Work> work_;
};

} // namespace voluta::motion
