// Slower beads, so that those below them have time to cool.
#pragma once

#include "plan/tool_plan.h"
#include "toolpath/options.h"

namespace voluta::toolpath {

// Lowers the speeds of the beads that are printed between a bead and the one that covers it, in
// proportion, where they take less than minLayerTimeS; not below slowestMmPerS. Counts no time
// for travel. Does nothing if one of the options is 0.
void slowToCool(plan::ToolPlan& plan, const CoolingOptions& options);

} // namespace voluta::toolpath
