// Where the arm waits for a change of the tool.
#pragma once

#include "motion/motion_scene.h"

namespace voluta::motion {

// Returns the joints at which the tool is changed and its nozzle purges: home, rotated about the
// arm's first joint as little as is needed, so that nothing drips on the plan's tool-paths (with
// 30 mm to spare); home itself if no rotation without a collision helps. The robot's base is
// upright.
robot::JointVector changePlace(const MotionScene& scene, const robot::JointVector& home);

} // namespace voluta::motion
