// Compares the temperatures and the fan that a program commands with those that the material needs.
#pragma once

#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/tooling.h"
#include "replay/alignment.h"
#include "replay/comparison.h"

#include <cstddef>
#include <vector>

namespace voluta::replay {

// For languages that can heat (ReadProgram::neededFacts), and materials with a known temperature.
// Returns a finding, with its line, for each of these:
// - a tool extrudes before its nozzle is commanded to its material's own temperature, within
//   kNozzleToleranceC, or, if the language has a word for it, before the program has waited for
//   that;
// - a nozzle is turned off or set to another temperature, and its tool extrudes later;
// - the same for the bed, if the first tool's material needs one: within
//   kBedToleranceC of its temperature;
// - a complete program ends with one of them heated.
// `firstPoint`: of the trajectory, where the text begins.
inline constexpr double kNozzleToleranceC = 5.0, kBedToleranceC = 10.0;
std::vector<TextFinding> compareHeat(const plan::ReadProgram& program,
                                     const plan::Trajectory& trajectory,
                                     const process::Tooling& tooling, std::size_t firstPoint = 0);

// For the same languages. Returns a finding at each bead from which on the fan runs at another
// speed than its material needs there (process/cooling.h), at most kMaxFanFindings. They are
// remarks: the part is printed, with poorer looks and bridges.
inline constexpr std::size_t kMaxFanFindings = 20;
std::vector<TextFinding> compareFan(const plan::ReadProgram& program, const plan::ToolPlan& plan,
                                    const plan::Trajectory& trajectory, const Alignment& alignment,
                                    const process::Tooling& tooling);

} // namespace voluta::replay
