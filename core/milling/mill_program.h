// The G-code of a milled part.
#pragma once

#include "milling/mill_passes.h"

#include <string>

namespace voluta::milling {

// Returns the origin of a side's coordinates: the middle of the block's top as that side sees it.
Eigen::Vector3d originOf(MillSide side, const Eigen::AlignedBox3d& block);

// Returns the program: side A in G54, the block turned by 180 deg about its axis A, side B and the
// contour in G55. Moves in mm, with the feed of the cutting data; rapid ones as G0. `name`: of the
// part, for the first comment.
std::string writeMilling(const MillPlan& plan, const MillRule& rule, const std::string& name);

} // namespace voluta::milling
