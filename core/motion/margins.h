// How far a motion stays from limits of joints and their speeds, and from singular poses: start,
// travel and end included.
#pragma once

#include "plan/trajectory.h"
#include "robot/cell.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// A joint where it comes nearest to one of its limits.
struct LimitMargin {
  double rad = 0.0; // to the nearer limit; mm of a sliding joint
  std::size_t point = 0;
};

// A joint where it moves fastest, between a point and the one before.
struct SpeedUse {
  double share = 0.0; // of its limit
  std::size_t point = 0;
};

struct MotionMargins {
  std::vector<LimitMargin> joints; // dof of them, external axes last
  std::vector<SpeedUse> speeds;    // likewise
  // The least ratio of the smallest to the largest singular value of the arm's Jacobian, lengths by
  // the arm's reach: 0 at a singular pose, at most 1 (Yoshikawa's isotropy; Lynch and Park, Modern
  // Robotics, 5.4).
  double isotropy = 1.0;
  std::size_t isotropyPoint = 0;
};

// Of every point. Precondition: the trajectory is the cell's. Throws Cancelled.
MotionMargins marginsOf(const plan::Trajectory& trajectory, const robot::Cell& cell,
                        const base::RunContext& ctx);

// The isotropy at one pose. `reachMm` > 0: the length that counts as one.
double isotropyAt(const robot::RobotModel& robot, const robot::JointVector& q, double reachMm);
// How far the wrist is from the base's first axis at most: the sum of the links.
double reachOf(const robot::RobotModel& robot);

} // namespace voluta::motion
