// The order of the events of a stop, whatever their kinds: the line that switches a heater off
// before the operator is awaited must not come behind it.
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "replay/alignment.h"
#include "replay/comparison.h"

#include <vector>

namespace voluta::replay {

// Returns a finding, at its line, for each stop of the trajectory whose events the program states
// in another order, or with less time between two of them than planned. Events that the program
// lacks are those of compareEvents().
std::vector<TextFinding> compareSequences(const plan::ReadProgram& program,
                                          const plan::Trajectory& trajectory,
                                          const Alignment& alignment);

} // namespace voluta::replay
