// Cuts a motion where the arm can wait: at lifted places between beads.
#pragma once

#include "plan/trajectory.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace voluta::together {

// Points of a trajectory at which the arm can rest: the first, the last, and those between. Segment
// i leads from point[i] to point[i + 1].
struct Rests {
  std::vector<std::size_t> point;      // ascending, at least two
  std::vector<std::size_t> filledFrom; // per rest: waypoints below this one are printed

  std::size_t segments() const { return point.size() - 1; }
};

// Returns the first and the last point of each travel between two beads that are neither at a bead
// nor on the way down to one; of these at most `maxCount`, the longest segments cut first.
// insideBeadsS: a point amid a bead too, where the last one is that long ago [s]; infinite: never.
// printedBefore: waypoints below it were printed before the trajectory.
Rests restsOf(const plan::Trajectory& trajectory, std::size_t maxCount,
              double insideBeadsS = std::numeric_limits<double>::infinity(),
              std::size_t printedBefore = 0);

// Returns the duration of each segment, waits included [s].
std::vector<double> secondsOf(const plan::Trajectory& trajectory, const Rests& rests);

} // namespace voluta::together
