// Where external axes that carry the platform go along a path: a positioner, not a rod. Chosen
// before the arm's way, which has them as given (path_ladder.h).
#pragma once

#include "motion/motion_scene.h"
#include "motion/run.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// The external axes at each of the waypoints [first, first + count), to follow on from.axes.
// They stay where they are as long as no direction of the path leans further than 20 degrees from
// upright there and the arm reaches it clear of everything. Else the cheapest way over a grid of
// their positions (turns of 15 degrees, slides of 26 mm): leaning costs, being held aside, moving,
// and positions in which the arm, in some branch and turn about the nozzle, gets to the path and
// meets nothing are gone through as far as a few searches find them; then it is evened out along
// the path. Always within the axes' limits; no promise that the arm follows. Preconditions: the
// cell has external axes and no rod; count >= 1. Throws Cancelled. The same for any number of
// threads.
std::vector<robot::JointVector> axisSchedule(const MotionScene& scene, std::size_t first,
                                             std::size_t count, const RobotState& from,
                                             const base::RunContext& ctx);

} // namespace voluta::motion
