// Winding back, by whole turns, of a table that cannot turn endlessly, between the stretches of a
// program in which it must not be wound.
#pragma once

#include <span>
#include <vector>

namespace voluta::program {

// The table's range of angles in a stretch [rad], counted continuously over all stretches.
struct AngleRange {
  double lowest = 0.0, highest = 0.0;
};

// Returns the turns to add in each stretch so that the table stays within `maxRad` to either side,
// with as few changes as possible, and then as small ones as possible. A stretch that does not fit
// is centred about 0 as far as whole turns allow.
std::vector<int> windings(std::span<const AngleRange> stretches, double maxRad);

// Returns whether every stretch can be brought within `maxRad` to either side.
bool fitWithin(std::span<const AngleRange> stretches, double maxRad);
// Returns the smallest whole number of turns to either side, at least 1, within which all stretches
// fit.
int minRevolutions(std::span<const AngleRange> stretches);

} // namespace voluta::program
