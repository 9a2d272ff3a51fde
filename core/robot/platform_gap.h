// Does the platform stand on what carries it?
#pragma once

#include "robot/cell.h"

namespace voluta::robot {

// How far the platform's plate lies beside the top of its stem, mm; 0 where they meet, and in a
// cell without a stem.
double platformGapMm(const Cell& cell);

} // namespace voluta::robot
