// What of an arm decides where it can print: how far it reaches and to which side, where it stands,
// where its flange points. Found by looking at many poses, so that every family has them.
#pragma once

#include "robot/robot_model.h"

#include <vector>

namespace voluta::cells {

// mm, in the base's frame, whose z is taken as up.
struct ArmFacts {
  Eigen::Vector3d foot = Eigen::Vector3d::Zero(); // where joint 1's axis meets the arm's underside
  double reachMm = 0.0;    // of the flange from joint 1's axis, at the height where it is largest
  double aheadRad = 0.0;   // about z from x: where it reaches with joint 1 in the middle
  bool uprightAxis = true; // joint 1's, within 5 degrees
  // z along the last joint's axis, away from the arm. The identity where the flange's own z lies
  // along that axis.
  Eigen::Matrix3d flange_R_outward = Eigen::Matrix3d::Identity();
};

// Precondition: links. Deterministic.
ArmFacts armFacts(const robot::RobotModel& robot);

// `count` poses drawn within the joints' limits, the same every time.
std::vector<robot::JointVector> drawnPoses(const std::vector<robot::JointLimits>& limits,
                                           std::size_t count);

} // namespace voluta::cells
