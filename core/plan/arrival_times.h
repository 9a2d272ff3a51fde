// The times of a trajectory's points with the waits between them.
#pragma once

#include "plan/trajectory.h"

#include <vector>

namespace voluta::plan {

// Returns per point the time at which it is reached [s], from 0. The motion to a point begins
// timeS[i] - timeS[i - 1] before that, after the waits before it.
std::vector<double> arrivalTimes(const Trajectory& trajectory);

} // namespace voluta::plan
