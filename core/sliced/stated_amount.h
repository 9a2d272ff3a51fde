// The material that a file's E words state, counted apart from the reader of its beads, to check
// it: the two share no code.
#pragma once

#include "sliced/sliced_file.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace voluta::sliced {

struct StatedAmount {
  double sum = 0.0;                 // in the unit of SlicedPoint::extruded
  std::vector<AmountAt> increments; // ascending lines, of the lines that extrude
};

// Returns the amount that leaves the nozzles: for each nozzle the most that was ever fed in all, as
// filament that was drawn back returns first. Follows the words of amounts only: E of whatever G
// command moves by it, known or not, and no motions.
StatedAmount statedAmount(std::string_view text, const SlicedHeader& header);

} // namespace voluta::sliced
