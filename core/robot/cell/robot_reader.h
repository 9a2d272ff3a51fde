// Reads a robot's description from a file of its own (resources/robots/ID.json) or inside another
// file.
#pragma once

#include "base/json_node.h"
#include "robot/robot_model.h"

namespace voluta::robot {

// Returns whether `robot` is a whole description, not an id.
bool holdsRobot(const base::JsonNode& robot);
// Throws Error{UnusableInput} naming file and key.
RobotModel readRobot(const base::JsonNode& top);

} // namespace voluta::robot
