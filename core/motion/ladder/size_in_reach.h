// For a part too large for its robot: the size at which the robot reaches it.
#pragma once

#include "motion/motion_scene.h"
#include "motion/refusal.h"

#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// Returns the largest scale of 0.95, 0.9, ... 0.2 at which the robot reaches the part: at most one
// in a hundred waypoints of a sample is missed. Half of the sample is from the `refused` waypoints
// that are unreachable. The waypoints are scaled about the middle of the plan on its ground and
// keep their directions. A point is reached if, for some rotation about the nozzle and some IK
// branch, the joints are within limits and no bodies of the cell collide; the printed part is not
// checked. Returns nullopt if there is no such size, or if the cell has external axes, whose motion
// would change. Throws Cancelled.
std::optional<double> sizeInReach(const MotionScene& scene, const std::vector<Refused>& refused,
                                  const base::RunContext& ctx);

} // namespace voluta::motion
