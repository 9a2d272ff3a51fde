// The order of a tool change in a program: the operator's stop with its text, the selection of the
// tool, its lock, its heat, its purge.
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "process/tooling.h"
#include "replay/alignment.h"
#include "replay/comparison.h"

#include <cstddef>
#include <vector>

namespace voluta::replay {

// Returns a finding, at its line, for each statement of a tool change that comes before another one
// which is planned before it, and for a prime before the pause that it follows; for a stop before
// the first motion whose text does not name the tool that the operator has to fit
// (program::toolName), in dialects that show one; and for a lacking wait for the nozzle's heat
// between selection and purge, in programs that heat; and for a release or a lock of a tool changer
// whose time does not pass before the next statement of the change. In a job of several tools the
// same holds of the stop and the selection before the first motion. A tool that the operator fits
// must not be heated before the stop for it, nor from the stop on at which the operator takes it
// off. Statements that are missing altogether are the business of compareEvents. `firstPoint`:
// point of the trajectory at which the program begins.
std::vector<TextFinding> compareChangeOrder(const plan::ReadProgram& program,
                                            const plan::Trajectory& trajectory,
                                            const Alignment& alignment,
                                            const process::Tooling& tooling,
                                            std::size_t firstPoint);

} // namespace voluta::replay
