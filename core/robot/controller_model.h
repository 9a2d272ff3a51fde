// Which of its maker's controllers a robot has, where programs differ by it.
#pragma once

#include <string>

namespace voluta::robot {

// ABB's with RobotWare 7.
inline constexpr const char* kOmniCore = "omnicore";

// Returns what the robot's file says (controllerModel); empty if it says nothing, or if no file has
// this id. Throws as readRobot.
std::string controllerModel(const std::string& robotId);

} // namespace voluta::robot
