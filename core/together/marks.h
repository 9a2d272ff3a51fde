// Writes the marks of a schedule into the motions.
#pragma once

#include "plan/trajectory.h"
#include "together/schedule.h"
#include "together/segments.h"

#include <cstddef>
#include <vector>

namespace voluta::together {

// Returns the points at which machine A, or B, rests at each mark; ascending.
std::vector<std::size_t> marksOfA(const Schedule& schedule, const Rests& rests);
std::vector<std::size_t> marksOfB(const Schedule& schedule, const Rests& rests);

// Returns the trajectory with a mark after the arrival at each of the points, before other events
// there. Precondition: the points are ascending and below pointCount().
plan::Trajectory withMarks(const plan::Trajectory& trajectory,
                           const std::vector<std::size_t>& points);

} // namespace voluta::together
