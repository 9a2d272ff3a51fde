// IK branch of an arm with a spherical wrist: one of up to eight solutions for a pose.
#pragma once

#include "robot/robot_model.h"

namespace voluta::program {

struct ArmBranch {
  bool behindAxis1 = false;    // the wrist centre is behind axis 1
  bool behindLowerArm = false; // the wrist centre is behind the lower arm, seen from axis 2
  bool axis5Negative = false;
};

// Precondition: six axes, link poses as returned by robot::Kinematics::linkPoses.
ArmBranch armBranch(const robot::RobotModel& robot, const robot::JointVector& q);

} // namespace voluta::program
