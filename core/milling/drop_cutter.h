// Heights at which a round cutter touches a part.
#pragma once

#include "milling/cutting_data.h"
#include "milling/height_map.h"

#include <vector>

namespace voluta::milling {

// Returns the lowest height of the cutter's tip over a point at which it does not cut into the
// part; HeightMap::kNone where the part is out of its reach.
double dropHeight(const HeightMap& part, const Cutter& cutter, const Eigen::Vector2d& at);

} // namespace voluta::milling
