// A tool changer: an output of the controller locks the tool on the arm. While it is off, the tool
// can fall.
#pragma once

#include "robot/cell.h"

namespace voluta::robot {

// Time that a tool changer needs to lock or to release its tool [s].
inline constexpr double kChangerS = 1.0;

inline bool hasChanger(const Cell& cell) {
  return cell.toolChange().by == ToolChange::By::Changer;
}

} // namespace voluta::robot
