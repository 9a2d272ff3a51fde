// The default appearance of an arm without a given shape: a housing around each joint's axis, a
// tube from each joint to the next, a foot and a flange, derived from its kinematics and the size
// of its collision solids.
#pragma once

#include "robot/robot_model.h"
#include "robot/shape/arm_shape.h"

namespace voluta::robot {

std::vector<ShapeSolid> defaultShape(const RobotModel& robot);

} // namespace voluta::robot
