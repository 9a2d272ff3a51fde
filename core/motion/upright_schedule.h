// Positions of a tilting and turning table along a path, for a machine whose nozzle cannot tilt:
// they follow from the path's directions (robot/upright_axes.h), up to the side to which the table
// tilts and whole turns.
#pragma once

#include "plan/tool_plan.h"
#include "robot/cell.h"

#include <cstddef>
#include <vector>

namespace voluta::motion {

// Returns the external axes at the waypoints [first, first + count), continuing from `from`. Of the
// two sides to which the table can tilt takes, at each waypoint, the one with the smallest rotation
// of both axes over the whole path. Where the second axis is free it moves evenly from its last to
// its next required angle. Ends before the first waypoint that neither side reaches within the
// limits without swinging between two waypoints. Preconditions: robot::tiltsPart(cell); the plan
// has first + count waypoints.
std::vector<robot::JointVector> uprightSchedule(const plan::ToolPlan& plan, const robot::Cell& cell,
                                                std::size_t first, std::size_t count,
                                                const robot::JointVector& from);

} // namespace voluta::motion
