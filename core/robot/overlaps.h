// Links whose solids are in each other whatever the arm does: what encloses them is, not they.
#pragma once

#include "robot/robot_model.h"

#include <utility>
#include <vector>

namespace voluta::robot {

// Pairs of links (indices into robot.links, the lower first) with one link or more between them
// whose solids overlap at more than half of the poses drawn within the joints' limits. Boxes and
// frusta are taken as the capsules of about their size. Deterministic.
std::vector<std::pair<int, int>> mostlyOverlapping(const RobotModel& robot);

} // namespace voluta::robot
