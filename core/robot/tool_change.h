// How a cell changes its tool.
#pragma once

#include "robot/robot_model.h"

#include <string_view>
#include <vector>

namespace voluta::robot {

// Joints of the arm before a dock of a tool changer and in it. Between them the arm moves straight
// in joint space.
struct ToolDock {
  JointVector before, in;
};

struct ToolChange {
  enum class By {
    Hand,   // The operator fits nozzle and material while the arm is at home
    Feeder, // One nozzle with several materials, or several nozzles that are switched: at home
    Changer // The arm puts its tool into a dock and takes another one
  };
  By by = By::Hand;
  std::vector<ToolDock> docks = {}; // Of a changer: one for each tool, in their order
};

} // namespace voluta::robot
