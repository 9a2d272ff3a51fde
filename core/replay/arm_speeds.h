// Joints that are asked to go faster than they can.
#pragma once

#include "replay/executed_path.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::replay {

// JointSpeed and BranchJump violations of a path whose arm joints and durations are known, in
// motion order, one line a motion: its worst joint. A joint that turns by more than a radian from
// one sample of the arm to the next has changed its branch. What an external axis' motor takes by
// steps is no speed; motions without a time are not judged.
std::vector<LimitViolation> speedViolations(const ExecutedPath& path, const robot::Cell& cell);

} // namespace voluta::replay
