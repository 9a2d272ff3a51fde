// Finds waypoints at which the head itself would collide, whatever the arm's pose.
#pragma once

#include "motion/motion_scene.h"
#include "motion/refusal.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// Returns for each waypoint the first one of the same path within two bead widths of path length
// before it: material deposited from there on is soft and shaped by the nozzle, so it is no
// obstacle to the head.
std::vector<std::size_t> headBefore(const plan::ToolPlan& plan);

// Returns for each waypoint None, or HeadPart or HeadPlatform if the head would collide with the
// part filled before `headBefore` (one per waypoint) or the platform, BeyondRod if the cell cannot
// print there at all, or Leans if its arm cannot tilt the nozzle that far. Throws Cancelled.
std::vector<Refusal> headRefusals(const MotionScene& scene,
                                  const std::vector<std::size_t>& headBefore,
                                  const base::RunContext& ctx);

} // namespace voluta::motion
