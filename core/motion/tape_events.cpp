#include "motion/tape_events.h"

#include "plan/waypoints.h"

#include <algorithm>
#include <vector>

namespace voluta::motion {

namespace {

// The waypoints of the plan make the place of the cut exact; this is for their rounding [mm].
constexpr double kSameMm = 1e-3;

// A waypoint that a run passes, and the point of the trajectory there.
struct Passed {
  std::size_t point = 0, waypoint = 0;
};

// Returns the waypoints of the run that ends at `last`, in order.
std::vector<Passed> runUntil(const plan::Trajectory& t, std::size_t last) {
  std::vector<Passed> run;
  std::size_t point = last;
  while (true) {
    if (t.waypoint[point] != plan::kNoWaypoint)
      run.push_back({point, t.waypoint[point]});
    if (t.move[point] != plan::MoveKind::Print || point == 0)
      break;
    --point;
  }
  std::ranges::reverse(run);
  return run;
}

} // namespace

void addCuts(plan::Trajectory& trajectory, const plan::ToolPlan& plan,
             const process::Tooling& tooling) {
  const std::size_t count = trajectory.pointCount();
  for (std::size_t last = 1; last < count; ++last) {
    const bool ends = trajectory.move[last] == plan::MoveKind::Print &&
                      (last + 1 == count || trajectory.move[last + 1] != plan::MoveKind::Print);
    if (!ends || trajectory.waypoint[last] == plan::kNoWaypoint)
      continue;
    const plan::ToolPath& path = *plan::pathOf(plan, trajectory.waypoint[last]);
    if (path.kind != plan::PathKind::Tape)
      continue;
    const double ahead = tooling.of(path).process.tape->cutAheadMm;
    const std::vector<Passed> run = runUntil(trajectory, last);
    double left = 0.0;
    std::size_t i = run.size() - 1;
    while (i > 0 && left < ahead - kSameMm) {
      left += (plan.position[run[i].waypoint] - plan.position[run[i - 1].waypoint]).norm();
      --i;
    }
    trajectory.events.push_back({.point = run[i].point + 1, .kind = plan::EventKind::Cut});
  }
  std::ranges::stable_sort(trajectory.events, {}, &plan::TrajectoryEvent::point);
}

} // namespace voluta::motion
