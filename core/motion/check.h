// The last look at a finished trajectory: every point, and points between where steps are large.
#pragma once

#include "motion/motion_scene.h"
#include "plan/trajectory.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

struct TrajectoryCollision {
  std::size_t point = 0; // of the trajectory: met at it, or on the way to it
  collision::Contact contact;
};

struct TrajectoryCheck {
  std::vector<TrajectoryCollision> collisions; // ascending, at most one a point
  // Nothing comes closer on any of the motions that meet nothing; at most capMm, and at most
  // collision::kWayExactMm less than the least distance.
  double minClearanceMm = 0.0;
  std::size_t closestPoint = 0; // at it, or on the way to it
};

// headBefore[w]: while printing at waypoint w the head is checked against what was filled before
// that waypoint (soft material excepted); elsewhere against all that is printed by then. At the
// waypoints themselves it is taken to be clear: see headRefusals.
TrajectoryCheck checkTrajectory(const plan::Trajectory& trajectory, const MotionScene& scene,
                                const std::vector<std::size_t>& headBefore, double capMm,
                                const base::RunContext& ctx);

} // namespace voluta::motion
