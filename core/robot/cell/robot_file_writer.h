// A robot's file of its own making (robot/cell/robot_reader.cpp), of family "chain".
#pragma once

#include "robot/kinematics/serial_chain.h"
#include "robot/robot_model.h"

#include <string>

namespace voluta::robot {

// `source`: where its numbers come from. Read back, the robot is the same but for rounding in the
// last places of turns.
std::string robotFileJson(const RobotModel& robot, const SerialChain& chain,
                          const std::string& source);

} // namespace voluta::robot
