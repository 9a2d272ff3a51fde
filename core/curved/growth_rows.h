// The schemes of growth that a user may choose from: one row each.
#pragma once

#include "curved/growth_row.h"

#include <vector>

namespace voluta::curved {

// In the order they are offered; the first is the one unless another is chosen.
const std::vector<GrowthRow>& growthRows();

} // namespace voluta::curved
