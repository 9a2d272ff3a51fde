#include "plan/waypoints.h"

#include "base/error.h"

#include <algorithm>

namespace voluta::plan {

const ToolPath* pathOf(const ToolPlan& plan, std::size_t waypoint) {
  const auto after = std::upper_bound(plan.paths.begin(), plan.paths.end(), waypoint,
                                      [](std::size_t w, const ToolPath& p) { return w < p.first; });
  return after == plan.paths.begin() || waypoint >= plan.waypointCount() ? nullptr : &*(after - 1);
}

std::size_t beadNumber(const ToolPlan& plan, std::size_t waypoint) {
  return 1 + static_cast<std::size_t>(pathOf(plan, waypoint) - plan.paths.data());
}

void appendWaypoint(ToolPlan& to, const ToolPlan& from, std::size_t waypoint) {
  to.position.push_back(from.position[waypoint]);
  to.direction.push_back(from.direction[waypoint]);
  to.widthMm.push_back(from.widthMm[waypoint]);
  to.heightMm.push_back(from.heightMm[waypoint]);
  to.speedMmPerS.push_back(from.speedMmPerS[waypoint]);
}

RestOfPlan without(const ToolPlan& plan, const std::vector<char>& marked) {
  base::require(marked.size() == plan.waypointCount(), "one mark per waypoint");
  RestOfPlan rest;
  rest.plan.fill = plan.fill;
  for (const ToolPath& path : plan.paths) {
    const std::size_t end = path.first + path.count;
    for (std::size_t b = path.first; b < end;) {
      std::size_t e = b;
      while (e < end && !marked[e])
        ++e;
      if (e - b >= 2) {
        ToolPath piece = path;
        piece.first = rest.waypoint.size();
        piece.count = e - b;
        piece.closed = path.closed && piece.count == path.count;
        rest.plan.paths.push_back(piece);
        for (std::size_t i = b; i < e; ++i)
          rest.waypoint.push_back(i);
      }
      b = e + 1;
    }
  }
  for (const std::size_t i : rest.waypoint)
    appendWaypoint(rest.plan, plan, i);
  return rest;
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

bool purgesFirst(const Trajectory& trajectory, std::size_t from) {
  for (const TrajectoryEvent& event : trajectory.events) {
    if (event.kind != EventKind::Purge || event.point <= from)
      continue;
    const auto begin = trajectory.move.begin() + static_cast<std::ptrdiff_t>(from) + 1,
               end = trajectory.move.begin() + static_cast<std::ptrdiff_t>(event.point);
    return std::find(begin, end, MoveKind::Print) == end;
  }
  return false;
}

bool primesAtStart(const ToolPlan& plan, const Trajectory& trajectory, std::size_t from) {
  return !trajectory.extrudedMm3.empty() && trajectory.extrudedMm3.back() > 0.0 &&
         !primesOnPath(plan, trajectory, from) && !purgesFirst(trajectory, from);
}

} // namespace voluta::plan
