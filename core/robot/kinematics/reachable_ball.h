// Checks whether a ball on the platform is within reach.
#pragma once

#include "robot/cell.h"

namespace voluta::robot {

// Returns whether the radius is at most that of reachableBallRadius (robot/cell.h). Needs one test,
// where that function takes a dozen.
bool reachesBall(const Cell& cell, double tiltRad, double radiusMm);

} // namespace voluta::robot
