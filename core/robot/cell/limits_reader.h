// Reads limits of a joint in a robot's or a cell's file.
#pragma once

#include "base/json_node.h"
#include "robot/robot_model.h"

namespace voluta::robot {

// Reads the keys minDeg, maxDeg, velocityDegPerS and accelerationDegPerS2 of a node, or for a
// sliding joint minMm, maxMm, velocityMmPerS and accelerationMmPerS2; other keys are ignored.
// Throws Error{UnusableInput}.
JointLimits readJointLimits(const base::JsonNode& joint, JointKind kind = JointKind::Turning);

} // namespace voluta::robot
