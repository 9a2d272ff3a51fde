// What a program states beside its motions (plan/stated_facts.h) against what the plan needs of the
// machine, in every language.
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "process/process.h"
#include "replay/alignment.h"
#include "replay/comparison.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::replay {

// Returns a finding, at its line, for each of these:
// - a needed statement that is missing before the first motion, or, what concerns material, before
//   anything flows; the operator's stop comes before the machine drives anywhere. A needed
//   temperature is that of a material whose usual one is known, and stays on until the first bead.
// - a stop that ends without the operator.
// - the flow output: its full value or its range are not the process' and the dialect's.
// - a mechanical unit that the cell does not have.
// - flags of a target, or those that the controller takes where it has none, other than the
//   trajectory's joints give.
// - corners rounded without a distance, and outputs set where the arm does not stop.
std::vector<TextFinding> compareStatedFacts(const plan::ReadProgram& program,
                                            const plan::Trajectory& trajectory,
                                            const Alignment& alignment, const robot::Cell& cell,
                                            const process::Process& process);

} // namespace voluta::replay
