// The material of beads.
#pragma once

#include "toolpath/coverage/bead.h"

#include <vector>

namespace voluta::toolpath {

// Returns the sum of length of the tip's path x section (mean of each segment's ends) [mm³].
double volumeOf(const std::vector<Bead>& beads);

} // namespace voluta::toolpath
