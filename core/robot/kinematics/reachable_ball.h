// Does a ball on the platform lie within reach?
#pragma once

#include "robot/cell.h"

namespace voluta::robot {

// Is it at most as large as the one of reachableBallRadius (robot/cell.h)? One look, where that
// takes a dozen.
bool reachesBall(const Cell& cell, double tiltRad, double radiusMm);

} // namespace voluta::robot
