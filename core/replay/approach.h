// The way of a machine's axes from its reference run to the start of the print, and the turns of a
// table that is wound back: motions that have no place on the part (plan::ProgramApproach).
#pragma once

#include "plan/program.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/tooling.h"
#include "replay/comparison.h"

#include <vector>

namespace voluta::replay {

// A first motion starts from any pose of the arm [rad/s, mm/s].
inline constexpr double kFirstRadPerS = 1.0471975511965976, kFirstMmPerS = 250.0;
// Returns how fast a machine that is no arm may go to its start [mm/s]: the process's travel speed
// if that is faster.
double firstMmPerS(const process::Process& process);

// Returns a finding at its line for each of them that is lower than the planned print needs: where
// a table carries the part, below what print and plate can reach while the table turns; otherwise
// below the first motion's target; for a way in X or Y at a height that is not stated; and for a
// way to the start faster than firstMmPerS, or than kFirstRadPerS.
std::vector<TextFinding> judgeApproach(const plan::ReadProgram& program, const plan::ToolPlan& plan,
                                       const platform::PlatformSolid& platform,
                                       const process::Tooling& tooling);

} // namespace voluta::replay
