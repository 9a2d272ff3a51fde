// What an arm looks like, from whatever says it: the meshes it came with, the shape in its file, or
// else its kinematics. For the eye alone.
#pragma once

#include "robot/shape/arm_shape.h"
#include "robot/urdf/link_meshes.h"

#include <vector>

namespace voluta::robot {

struct ArmLook {
  std::vector<LinkMesh> meshes;   // of frames that have one
  std::vector<ShapeSolid> solids; // of the other frames
};

// Reads the robot's file again. An arm whose file is gone or unreadable has its default shape.
ArmLook lookOf(const RobotModel& robot);

} // namespace voluta::robot
