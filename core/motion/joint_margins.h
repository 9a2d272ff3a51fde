// Margins of a motion to the limits of joints and their speeds, and to singular poses; start,
// travels and end included.
#pragma once

#include "plan/trajectory.h"
#include "robot/cell.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// The point at which a joint is nearest to one of its limits.
struct LimitMargin {
  double rad = 0.0; // Distance to the nearer limit; [mm] for a sliding joint
  std::size_t point = 0;
};

// The point at which a joint moves fastest, between it and the previous point.
struct SpeedUse {
  double share = 0.0; // Share of its limit
  std::size_t point = 0;
};

struct MotionMargins {
  std::vector<LimitMargin> joints; // One per degree of freedom, external axes last
  std::vector<SpeedUse> speeds;    // One per degree of freedom, external axes last
  // Minimum ratio of the smallest to the largest singular value of the arm's Jacobian, with lengths
  // relative to the arm's reach: 0 at a singular pose, at most 1 (Yoshikawa's isotropy; Lynch and
  // Park, Modern Robotics, 5.4).
  double isotropy = 1.0;
  std::size_t isotropyPoint = 0;
};

// Returns the margins over all points. Precondition: the trajectory is the cell's. Throws
// Cancelled.
MotionMargins marginsOf(const plan::Trajectory& trajectory, const robot::Cell& cell,
                        const base::RunContext& ctx);

// Returns the isotropy at one pose. `reachMm` > 0: the length used as unit.
double isotropyAt(const robot::RobotModel& robot, const robot::JointVector& q, double reachMm);
// Returns the maximum distance of the wrist from the base's first axis: the sum of the links.
double reachOf(const robot::RobotModel& robot);

} // namespace voluta::motion
