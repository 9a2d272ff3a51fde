#include "plan/waypoints.h"

#include <algorithm>

namespace voluta::plan {

const ToolPath* pathOf(const ToolPlan& plan, std::size_t waypoint) {
  const auto after = std::upper_bound(plan.paths.begin(), plan.paths.end(), waypoint,
                                      [](std::size_t w, const ToolPath& p) { return w < p.first; });
  return after == plan.paths.begin() || waypoint >= plan.waypointCount() ? nullptr : &*(after - 1);
}

std::size_t waypointAhead(const Trajectory& trajectory, std::size_t point) {
  for (std::size_t i = point; i < trajectory.pointCount(); ++i)
    if (trajectory.waypoint[i] != kNoWaypoint)
      return trajectory.waypoint[i];
  return kNoWaypoint;
}

bool primesOnPath(const ToolPlan& plan, const Trajectory& trajectory, std::size_t from) {
  return plan.primes() && waypointAhead(trajectory, from) < plan.paths.front().count;
}

} // namespace voluta::plan
