// A robot's description inside another file (resources/robots/ID.json on its own).
#pragma once

#include "base/json_node.h"
#include "robot/robot_model.h"

namespace voluta::robot {

// Returns whether `robot` is a whole description and not an id.
bool holdsRobot(const base::JsonNode& robot);
// Throws Error{UnusableInput} naming file and key.
RobotModel readRobot(const base::JsonNode& top);

} // namespace voluta::robot
