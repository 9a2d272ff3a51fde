// Thickens beads that would be unsupported a little above printed material.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"

#include <vector>

namespace voluta::toolpath {

// In unsupported stretches (bridges.h) longer than half of the bridge length of their tool's
// process, thickens beads down to earlier material if that is within the remaining layer height
// range. Their tips stay; the speed is limited by the extruder's flow for the larger section.
// Clears their marks. Returns whether any bead was thickened. Preconditions: `part` contains the
// plan's beads, `hanging` is unsupportedWaypoints() of both.
bool thickenUnsupported(plan::ToolPlan& plan, std::vector<char>& hanging,
                        const collision::GrowingPart& part, const process::Tooling& tooling);

} // namespace voluta::toolpath
