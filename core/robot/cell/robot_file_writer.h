// Writes a robot's file (robot/cell/robot_reader.cpp) of family "chain".
#pragma once

#include "robot/kinematics/serial_chain.h"
#include "robot/robot_model.h"

#include <string>

namespace voluta::robot {

// `source`: where its numbers come from. The robot read back is the same up to rounding in the last
// digits of rotations.
std::string robotFileJson(const RobotModel& robot, const SerialChain& chain,
                          const std::string& source);

} // namespace voluta::robot
