// Positions of the external axes that carry the platform (a positioner, not a rod) along a path.
// They are chosen before the arm's motion, which takes them as given (path_ladder.h).
#pragma once

#include "motion/bead_run.h"
#include "motion/motion_scene.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// Returns the external axes at each of the waypoints [first, first + count), continuing from
// from.axes. They stay in place as long as no direction of the path is tilted more than 20 degrees
// from upright there and the arm reaches the whole path without collision. Otherwise returns the
// cheapest path over a grid of axis positions (rotations of 15 degrees, slides of 26 mm), smoothed
// along the tool-path. Tilting, lateral offset and moving have a cost, and so has every position
// that the arm cannot reach without collision in any IK branch and nozzle rotation, as far as a few
// searches discover it. The result is always within the axes' limits, but the arm may be unable to
// follow. In a cell that tilts the part (robot/upright_axes.h) returns uprightSchedule() instead,
// of as many waypoints as that reaches. Preconditions: the cell has external axes and no rod; count
// >= 1. Throws Cancelled. The result is independent of the number of threads.
std::vector<robot::JointVector> axisSchedule(const MotionScene& scene, std::size_t first,
                                             std::size_t count, const RobotState& from,
                                             const base::RunContext& ctx);

} // namespace voluta::motion
