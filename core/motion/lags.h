// Events for extruders whose material lags behind their command (process::ExtruderLag).
#pragma once

#include "plan/trajectory.h"
#include "process/process.h"

#include <cstddef>

namespace voluta::motion {

// Adds the events of a bead whose motions lead to the points [first, end): StartLag before its
// first motion, and StopLag before the motion from which the time to the bead's end is nearest to
// the stop lag; before the first one, the extruder is switched off during the start lag.
// Preconditions: 0 < first < end; no later event yet.
void addLags(plan::Trajectory& trajectory, std::size_t first, std::size_t end,
             const process::ExtruderLag& lag);

// Returns the duration of all start lags [s].
double startLagsS(const plan::Trajectory& trajectory);

} // namespace voluta::motion
