// The plate of a cell's platform, and whether it stands on what carries it.
#pragma once

#include "robot/cell.h"

namespace voluta::robot {

// nullptr: the platform is no plate.
const Prism* plateOf(const Cell& cell);

// How far the plate lies beside the top of its stem, mm; 0 where they meet, and in a cell without a
// stem.
double platformGapMm(const Cell& cell);

} // namespace voluta::robot
