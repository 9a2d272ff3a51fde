// Fewer waypoints where beads are straight.
#pragma once

#include "plan/tool_plan.h"

namespace voluta::toolpath {

// Removes waypoints between which nothing changes: the bead is straight within `chordMm`, the
// nozzle's direction and the speed are the same, and width and height change evenly. The rest is at
// most six bead widths and `longestMm` apart where waypoints were removed. Ends of paths stay, and
// paths without plastic. Precondition: both > 0.
plan::ToolPlan withoutIdleWaypoints(const plan::ToolPlan& plan, double chordMm, double longestMm);

// Returns whether the nozzle has the same direction at every waypoint.
bool hasOneDirection(const plan::ToolPlan& plan);

} // namespace voluta::toolpath
