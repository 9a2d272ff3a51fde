// The material that a file's E words state, counted apart from its beads, to check the reader.
#pragma once

#include "sliced/sliced_file.h"

#include <string_view>

namespace voluta::sliced {

// Returns the sum that leaves the nozzles, in the unit of SlicedPoint::extruded: for each nozzle
// the most that was ever fed in all, as filament that was drawn back returns first. Follows the
// words of amounts only, no motions.
double statedAmount(std::string_view text, const SlicedHeader& header);

} // namespace voluta::sliced
