// Jerk of the joints along a trajectory, for plots.
#pragma once

#include "plan/trajectory.h"

#include <vector>

namespace voluta::plan {

// Returns the jerk of each joint at each point [rad/s3] (sliding axes: [mm/s3]), one row per joint:
// third differences over each sequence of printing moves and over each sequence of moves of one
// other kind, from rest to rest. Steps without a duration count as none.
std::vector<std::vector<float>> jerkAlong(const Trajectory& trajectory);

} // namespace voluta::plan
