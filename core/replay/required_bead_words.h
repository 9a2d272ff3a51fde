// The statements of a process at the starts and ends of beads (process::BeadWords).
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "process/tooling.h"
#include "replay/alignment.h"
#include "replay/comparison.h"

#include <vector>

namespace voluta::replay {

// Returns a finding, at its line, for each statement that is missing before the first motion of a
// bead or behind its last one, and for each that is stated in another order or elsewhere.
std::vector<TextFinding> compareBeadWords(const plan::ReadProgram& program,
                                          const plan::Trajectory& trajectory,
                                          const Alignment& alignment,
                                          const process::Tooling& tooling);

} // namespace voluta::replay
