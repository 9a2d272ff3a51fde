// Cuts of tapes in a trajectory.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/tooling.h"

namespace voluta::motion {

// Adds an event that cuts the tape to each tape laid in one go: where the length between the cutter
// and the place that is ironed on is left, so that the rest is ironed on after the cut. A tape of
// less than that length is cut as soon as it is begun. Keeps the other events.
void addCuts(plan::Trajectory& trajectory, const plan::ToolPlan& plan,
             const process::Tooling& tooling);

} // namespace voluta::motion
