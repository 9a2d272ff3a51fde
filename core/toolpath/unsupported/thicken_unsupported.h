// Beads that would hang a little over what is printed, laid thicker.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "process/process.h"

#include <vector>

namespace voluta::toolpath {

// Where a stretch that nothing carries (bridges.h) is longer than half of what the process bridges,
// and what is printed before lies beneath it by less than a bead may still be thicker, the beads
// are laid down to it: their tips stay, no faster than the extruder gives what they hold. Their
// marks go. True: some are. Preconditions: `part` holds the plan's beads, `hanging` is
// unsupportedWaypoints() of both.
bool thickenUnsupported(plan::ToolPlan& plan, std::vector<char>& hanging,
                        const collision::GrowingPart& part, const process::Process& process);

} // namespace voluta::toolpath
