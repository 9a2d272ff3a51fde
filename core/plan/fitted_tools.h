// Tools that the operator fits during a print.
#pragma once

#include "plan/trajectory.h"

namespace voluta::plan {

// Returns whether a change to that tool is a pause (Trajectory::changeAfter), in which the operator
// fits it: before that the machine does not have it.
bool isFittedByHand(const Trajectory& trajectory, int tool);

} // namespace voluta::plan
