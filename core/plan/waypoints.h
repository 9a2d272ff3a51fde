// Lookup of a waypoint's path and of the waypoint that a trajectory point leads to.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"

#include <cstddef>
#include <vector>

namespace voluta::plan {

// Returns the path of the waypoint, or nullptr if the plan has no such waypoint.
const ToolPath* pathOf(const ToolPlan& plan, std::size_t waypoint);

// Returns the number of the waypoint's bead among all paths, counted from 1. Precondition: the plan
// has the waypoint.
std::size_t beadNumber(const ToolPlan& plan, std::size_t waypoint);

// Appends a copy of one waypoint to another plan; paths stay unchanged.
void appendWaypoint(ToolPlan& to, const ToolPlan& from, std::size_t waypoint);

struct RestOfPlan {
  ToolPlan plan;
  std::vector<std::size_t> waypoint; // Per waypoint of this plan: its index in the original plan
};

// Returns the plan without the marked waypoints. A path is split at them, and pieces of a single
// waypoint are dropped as well. Precondition: one mark per waypoint.
RestOfPlan without(const ToolPlan& plan, const std::vector<char>& marked);

// Returns the waypoint at this point or the next one after it; kNoWaypoint after the last one.
std::size_t waypointAhead(const Trajectory& trajectory, std::size_t point);

// Returns whether the motion, from this point on, first primes the nozzle with a waste bead. False
// if the plan's priming bead is not in the motion, because it could not be planned or comes before
// the rest of a resumed print.
bool primesOnPath(const ToolPlan& plan, const Trajectory& trajectory, std::size_t from = 0);

// Returns whether the nozzle is purged after that point and before anything is printed.
bool purgesFirst(const Trajectory& trajectory, std::size_t from = 0);

// Returns whether a program that begins at that point has to prime the nozzle with the arm at rest
// at its start: it prints, and neither a waste bead nor a purge comes first.
bool primesAtStart(const ToolPlan& plan, const Trajectory& trajectory, std::size_t from = 0);

} // namespace voluta::plan
