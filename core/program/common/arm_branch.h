// Which of the eight ways of an arm with a spherical wrist to stand at a pose.
#pragma once

#include "robot/robot_model.h"

namespace voluta::program {

struct ArmBranch {
  bool behindAxis1 = false;    // the wrist's centre
  bool behindLowerArm = false; // likewise, seen from axis 2 along the lower arm
  bool axis5Negative = false;
};

// Precondition: six axes, links as robot::Kinematics::linkPoses gives them.
ArmBranch armBranch(const robot::RobotModel& robot, const robot::JointVector& q);

} // namespace voluta::program
