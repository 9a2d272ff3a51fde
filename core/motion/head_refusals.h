// Where the head itself, whatever the arm does, would be in the way.
#pragma once

#include "motion/motion_scene.h"
#include "motion/refusal.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// For each waypoint the first one of the same path that lies within two bead widths of way before
// it: what was laid from there on is soft and shaped by the nozzle, and no obstacle to the head.
std::vector<std::size_t> headBefore(const plan::ToolPlan& plan);

// Where the head would meet the platform, or the part filled before `headBefore` (one a waypoint):
// for each waypoint None, HeadPart or HeadPlatform; BeyondRod where the cell does not print at all,
// Leans where its arm cannot lean the nozzle so.
// Throws Cancelled.
std::vector<Refusal> headRefusals(const MotionScene& scene,
                                  const std::vector<std::size_t>& headBefore,
                                  const base::RunContext& ctx);

} // namespace voluta::motion
