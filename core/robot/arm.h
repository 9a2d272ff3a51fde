// An arm of a cell: its robot, its pose at rest, and its joints among the cell's.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>

namespace voluta::robot {

struct Arm {
  RobotModel robot;
  JointVector home; // at rest, jointCount() joints within robot.limits: rad, mm of sliding joints
  // In a joint vector of the cell this arm's are [firstJoint, firstJoint + jointCount()).
  int firstJoint = 0;

  int jointCount() const { return robot.dof(); }
};

} // namespace voluta::robot
