// Whole turns by which a table that cannot turn without end is wound back between the stretches of
// a program in which it must not be.
#pragma once

#include <span>
#include <vector>

namespace voluta::program {

// Between which angles the table stands in a stretch, rad, counted on from stretch to stretch.
struct TurnRange {
  double lowest = 0.0, highest = 0.0;
};

// Turns to be added in each stretch, so that it stands within `mostRad` to either side: changed as
// seldom as can be, and then by as little. Of a stretch that does not fit at all they bring its
// middle next to 0.
std::vector<int> windings(std::span<const TurnRange> stretches, double mostRad);

// Can each be brought within `mostRad` to either side?
bool fitWithin(std::span<const TurnRange> stretches, double mostRad);
// The least whole number of turns to either side, 1 or more, that they fit within.
int leastTurns(std::span<const TurnRange> stretches);

} // namespace voluta::program
