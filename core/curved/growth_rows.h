// The growth schemes offered to users: one row each.
#pragma once

#include "curved/growth_row.h"

#include <vector>

namespace voluta::curved {

// Returns the rows in display order; the first is the default.
const std::vector<GrowthRow>& growthRows();

} // namespace voluta::curved
