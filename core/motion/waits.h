// Waits above the part until the beads below have cooled.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::motion {

// Returns the waits, ascending by point, after which every bead is at least `minS` old where
// another one covers it. Each wait is as short as possible and on the travel to the bead that would
// cover a place too early, where the nozzle is highest above the ends of the travel. No wait can
// help where a run covers itself, as a spiral does. Preconditions: minS > 0; no waits yet.
std::vector<plan::TrajectoryEvent> waitsToCool(const plan::ToolPlan& plan,
                                               const plan::Trajectory& trajectory,
                                               const robot::Cell& cell, double minS);

// Returns per waypoint the planned time [s] since the bead below it was printed, the shortest one
// around it; negative where there is no bead below. Includes waits.
std::vector<float> layerTimesOf(const plan::ToolPlan& plan, const plan::Trajectory& trajectory);

} // namespace voluta::motion
