// Slows a motion down where the jerk of its joints would exceed a limit.
#pragma once

#include "robot/robot_model.h"

#include <vector>

namespace voluta::motion {

// Returns times [s] from rest to rest over which no joint's jerk (jerkStencils(), sliding joints by
// robot::asAngle) exceeds maxJerk [rad/s3], with the ramps at both ends and the changes of speed
// about slower places. No step gets shorter; apart from ramps from and to rest, none gets more than
// kMaxSlowdown times as long: if that does not suffice, the jerk is only reduced. `q`: the joints
// at each of `times`, which increase. Joints without an entry in `limits` count as turning.
// Precondition: maxJerk > 0.
std::vector<double> timesWithinJerk(const std::vector<robot::JointVector>& q,
                                    const std::vector<double>& times,
                                    const std::vector<robot::JointLimits>& limits, double maxJerk);

// A bead that is printed more slowly than this does not keep its section.
inline constexpr double kMaxSlowdown = 20.0;

} // namespace voluta::motion
