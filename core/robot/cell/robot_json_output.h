// Poses and joints as JSON text [mm, degrees] for `voluta-cli robot`
// (docs/design.md, Command line).
#pragma once

#include "robot/robot_model.h"

#include <string>
#include <vector>

namespace voluta::robot {

// Returns {"positionMm": [x, y, z], "quaternion": [w, x, y, z]} of the flange in the controller's
// base; w >= 0. `joints` in degrees, sliding ones in mm. Throws Error{Usage} if the number of
// joints is not the robot's or a value is not finite.
std::string forwardJson(const RobotModel& robot, const std::vector<double>& joints);

// Returns {"solutions": [[q1, ..., qn], ...]}: all IK branches inside the limits, each joint as
// near to zero as whole turns allow, in degrees, sliding ones in mm; an empty list if the pose is
// out of reach. `pose` is x, y, z, qw, qx, qy, qz (mm; the quaternion is normalised). Throws
// Error{Usage} if it is not seven finite numbers or the quaternion's length is not 1 within 1 %.
std::string inverseJson(const RobotModel& robot, const std::vector<double>& pose);

} // namespace voluta::robot
