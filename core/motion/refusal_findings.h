// Findings for waypoints that cannot be printed.
#pragma once

#include "motion/motion_scene.h"
#include "motion/refusal.h"
#include "plan/finding.h"

#include <functional>
#include <vector>

namespace voluta::motion {

// Returns one finding for each row of neighbouring waypoints refused for the same reason; from the
// 100th on, one for all of a reason, and always one for all that lean. `whenS(waypoint)`: program
// time at the waypoint [s].
plan::Findings findingsOf(const std::vector<Refused>& refused, const MotionScene& scene,
                          const std::function<double(std::size_t)>& whenS);

// Returns e.g. "layer 12, x 3.1 y -4.0 z 20.2".
base::Message placeOf(const MotionScene& scene, std::size_t waypoint);

} // namespace voluta::motion
