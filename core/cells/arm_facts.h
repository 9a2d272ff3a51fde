// Properties of an arm that determine where it can print: reach, preferred side, foot and flange
// axis. They are computed by sampling poses and therefore exist for every arm family.
#pragma once

#include "robot/robot_model.h"

#include <vector>

namespace voluta::cells {

// Lengths in mm, in the base's frame, whose z is assumed to point up.
struct ArmFacts {
  // intersection of joint 1's axis with the arm's underside
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();
  double reachMm = 0.0; // maximum distance of the flange from joint 1's axis
  // angle about z from x: direction of reach with joint 1 at the middle of its range
  double aheadRad = 0.0;
  bool uprightAxis = true; // whether joint 1's axis is upright within 5 degrees
  // Frame with z along the last joint's axis, away from the arm. The identity if the flange's own z
  // is parallel to that axis.
  Eigen::Matrix3d flange_R_outward = Eigen::Matrix3d::Identity();
};

// Precondition: the robot has links. Deterministic.
ArmFacts armFacts(const robot::RobotModel& robot);

// Returns `count` random poses within the joints' limits; deterministic.
std::vector<robot::JointVector> drawnPoses(const std::vector<robot::JointLimits>& limits,
                                           std::size_t count);

} // namespace voluta::cells
