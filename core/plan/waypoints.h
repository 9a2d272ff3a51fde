// Where a waypoint is found: the path it is of, and the point of a trajectory that leads to it.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"

#include <cstddef>
#include <vector>

namespace voluta::plan {

// The path that the waypoint is of; null: the plan has no such waypoint.
const ToolPath* pathOf(const ToolPlan& plan, std::size_t waypoint);

// Copies one waypoint behind those of another plan; paths stay as they are.
void appendWaypoint(ToolPlan& to, const ToolPlan& from, std::size_t waypoint);

struct RestOfPlan {
  ToolPlan plan;
  std::vector<std::size_t> waypoint; // of the plan before, per waypoint of this one
};

// The plan without the marked waypoints: their path ends before them and goes on after them as one
// of its own, and pieces of a single waypoint go too. Precondition: one mark a waypoint.
RestOfPlan without(const ToolPlan& plan, const std::vector<char>& marked);

// The waypoint that a point is, or is on the way to; kNoWaypoint: it follows the last one.
std::size_t waypointAhead(const Trajectory& trajectory, std::size_t point);

// Does a bead that is waste fill the nozzle first, from a point of the motion on? Not of a plan
// whose bead for that is not in the motion: it could not be planned, or lies before the rest of a
// print.
bool primesOnPath(const ToolPlan& plan, const Trajectory& trajectory, std::size_t from = 0);

} // namespace voluta::plan
