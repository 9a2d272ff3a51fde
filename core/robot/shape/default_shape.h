// What an arm looks like of which nobody has said it: a housing about each joint's axis, a tube
// from each joint to the next, a foot and a flange, from its kinematics and the size of its solids.
#pragma once

#include "robot/robot_model.h"
#include "robot/shape/arm_shape.h"

namespace voluta::robot {

std::vector<ShapeSolid> defaultShape(const RobotModel& robot);

} // namespace voluta::robot
