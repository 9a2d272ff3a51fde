// What a part that is too large for its robot is told: the size at which the robot gets to it.
#pragma once

#include "motion/motion_scene.h"
#include "motion/refusal.h"

#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// The largest share of its size, of 0.95, 0.9, ... 0.2, at which the robot gets to the part: all
// but one in a hundred of a sample of waypoints, half of it of those that are `refused` as
// unreachable, brought nearer to the middle of the plan on its ground with the direction that they
// have. The robot gets to a place where some turn about the nozzle and some branch of the arm are
// within limits and no bodies of the cell meet; what is printed is not asked. nullopt: there is no
// such size, or the cell has external axes, which would go another way. Throws Cancelled.
std::optional<double> sizeInReach(const MotionScene& scene, const std::vector<Refused>& refused,
                                  const base::RunContext& ctx);

} // namespace voluta::motion
