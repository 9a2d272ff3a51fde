// From beads to a robot's motion: ladder graph a path at a time, transfers, timing, checks.
#pragma once

#include "collision/growing_part.h"
#include "motion/motion_options.h"
#include "motion/too_large.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/process.h"
#include "robot/cell.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// "motion" of report.json.
struct MotionStatistics {
  std::size_t waypoints = 0;   // printed
  std::size_t unreachable = 0; // waypoints left out: out of reach, or joined to no neighbour
  std::size_t collisions = 0;  // waypoints left out because something would meet, and points of
                               // the finished trajectory at which something does (none, ever)
  std::size_t splits = 0;      // paths are printed in so many more pieces than there are paths
  std::size_t transfers = 0, arcTransfers = 0, jointTransfers = 0, treeTransfers = 0;
  std::vector<double> maxJerk; // a joint, rad/s3 (mm/s3), while printing
  // Before: with the turns that the ladder gave, over the same times.
  double sumSquaredJerk = 0.0, sumSquaredJerkBefore = 0.0;
  double minClearanceMm = 0.0; // of bodies and part, the head's to plate and part left out; at most
                               // kClearanceCapMm
  double minClearanceAtS = 0.0; // when it is that
  double leftOutFraction = 0.0; // of the plan's material, with all waypoints that are not printed
  double durationS = 0.0;
};
inline constexpr double kClearanceCapMm = 100.0;

// Wall seconds, disjoint.
struct MotionTimes {
  double ik = 0.0, graph = 0.0, jerk = 0.0, collision = 0.0, transfer = 0.0;
};

struct MotionResult {
  bool isGivenUp = false; // there are findings only
  plan::Trajectory trajectory;
  std::vector<std::size_t> skipped; // waypoints that are not printed, ascending
  plan::Findings findings;
  std::optional<TooLarge> tooLarge; // to be told before the findings
  MotionStatistics statistics;
  MotionTimes times;
};

// Plans the whole program: home, to the first path, every path with transfers between, home.
// Waypoints that cannot be reached or would collide are left out, named in findings and listed in
// skipped; the paths are printed without them. What meets something where the finished motion is
// looked at more closely, between points too, is planned again without the waypoints concerned.
// Where at most half a percent of the material is left out, that is told and does not block.
// Print points carry the waypoint's index, or none where a step was divided; a run's first point is
// reached by a Linear (or Joint) move and carries its waypoint too. Where a path had to be split,
// the waypoint at the split appears at the end of one run and again at the start of the next.
// extrudedMm3 rises at Print points only, by the mean of the sections at both waypoints times their
// distance. A rod is at a multiple of its step at every point; at the end it rests at a whole turn
// where it runs on. The same result for any number of threads.
// Example:
//   const double pitch = collision::growingPitch(toolPlan, process);
//   const collision::GrowingPart growing(toolPlan, pitch, ctx);
//   motion::MotionPlanner planner(toolPlan, cell, process, growing, {});
//   const motion::MotionResult moved = planner.plan(ctx);
class MotionPlanner {
public:
  // All of them must outlive the planner. Preconditions: part was grown from `plan`; process is the
  // cell's.
  MotionPlanner(const plan::ToolPlan& plan, const robot::Cell& cell,
                const process::Process& process, const collision::GrowingPart& part,
                const MotionOptions& options);
  ~MotionPlanner();

  // Gives up as soon as it is known that more than `mostLeftOut` of the material cannot be printed.
  // Throws Cancelled. The planner is of no use after either.
  MotionResult plan(const base::RunContext& ctx, double mostLeftOut = 1.0);
  // After plan: the same without these waypoints and those of earlier calls, since something was
  // found to meet there. Only the paths that have them are planned again. Throws Cancelled.
  MotionResult planWithout(const std::vector<std::size_t>& waypoints, const base::RunContext& ctx);

private:
  class Work;
  std::unique_ptr<Work> work_;
};

} // namespace voluta::motion
