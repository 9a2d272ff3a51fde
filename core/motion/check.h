// Final check of a trajectory: collisions and clearance at every point, and between points where
// steps are large.
#pragma once

#include "collision/cell_collision.h"
#include "motion/motion_scene.h"
#include "plan/trajectory.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

struct TrajectoryCollision {
  std::size_t point = 0; // Of the trajectory; the collision is at this point or on the motion to it
  collision::Contact contact;
};

struct TrajectoryCheck {
  std::vector<TrajectoryCollision> collisions; // Ascending; at most one per point
  // Minimum clearance of all motions without collision; at most capMm. May be up to
  // collision::kMotionExactMm less than the exact value.
  double minClearanceMm = 0.0;
  std::size_t closestPoint = 0; // At this point, or on the motion to it
};

// headBefore[w]: while printing at waypoint w, the head is checked against the part filled before
// that waypoint (without soft material); otherwise against everything printed by then. At the
// waypoints themselves the head is assumed to be clear: see headRefusals.
TrajectoryCheck checkTrajectory(const plan::Trajectory& trajectory, const MotionScene& scene,
                                const std::vector<std::size_t>& headBefore, double capMm,
                                const base::RunContext& ctx);

} // namespace voluta::motion
