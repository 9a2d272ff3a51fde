// Compares a program's statements beside its motions (plan/stated_facts.h) with the machine
// settings that the plan needs, in every language.
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "process/tooling.h"
#include "replay/alignment.h"
#include "replay/comparison.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::replay {

// Returns a finding, with its line, for each of these:
// - a required statement is missing before the first motion, or, if it concerns material, before
//   anything flows. The operator's stop must come before any motion of the machine. Temperatures:
//   heat_facts.h;
// - a stop ends without the operator;
// - the full value or the range of the flow output differs from the process or the dialect;
// - the cell does not have a mechanical unit;
// - the flags of a target, or those that the controller assumes without any, differ from the
//   trajectory's joints;
// - corners are rounded without a distance, or outputs are set where the arm does not stop.
std::vector<TextFinding> compareStatedFacts(const plan::ReadProgram& program,
                                            const plan::Trajectory& trajectory,
                                            const Alignment& alignment, const robot::Cell& cell,
                                            const process::Tooling& tooling);

} // namespace voluta::replay
