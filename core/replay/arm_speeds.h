// Check of joint speeds against their limits.
#pragma once

#include "replay/executed_path.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::replay {

// Returns the JointSpeed and BranchJump violations of a path whose arm joints and durations are
// known, in motion order, one per motion (its worst joint). A joint that turns by more than 1 rad
// between two samples of the arm has changed its IK branch. Axes whose motor is moved in steps have
// no speed; motions without a duration are not checked.
std::vector<LimitViolation> speedViolations(const ExecutedPath& path, const robot::Cell& cell);

} // namespace voluta::replay
