// The visual appearance of an arm: its meshes, the shape in its file, or a shape derived from its
// kinematics. For display only.
#pragma once

#include "robot/shape/arm_shape.h"
#include "robot/urdf/link_meshes.h"

#include <vector>

namespace voluta::robot {

struct ArmLook {
  std::vector<LinkMesh> meshes;   // Of frames that have one
  std::vector<ShapeSolid> solids; // Of the other frames
};

// Reads the robot's file again. An arm whose file is missing or unreadable gets the default shape.
ArmLook lookOf(const RobotModel& robot);

} // namespace voluta::robot
