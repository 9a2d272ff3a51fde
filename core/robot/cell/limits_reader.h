// Limits of a joint in a robot's or a cell's file.
#pragma once

#include "base/json_node.h"
#include "robot/robot_model.h"

namespace voluta::robot {

// The keys minDeg, maxDeg, velocityDegPerS and accelerationDegPerS2 of a node, of a sliding joint
// minMm, maxMm, velocityMmPerS and accelerationMmPerS2; it may hold others.
// Throws Error{UnusableInput}.
JointLimits readJointLimits(const base::JsonNode& joint, JointKind kind = JointKind::Turning);

} // namespace voluta::robot
