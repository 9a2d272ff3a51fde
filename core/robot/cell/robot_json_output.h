// Poses and joints as JSON text, degrees and mm, for `voluta-cli robot`
// (docs/design.md, Command line).
#pragma once

#include "robot/robot_model.h"

#include <string>
#include <vector>

namespace voluta::robot {

// {"positionMm": [x, y, z], "quaternion": [w, x, y, z]} of the flange in the controller's base;
// w >= 0. `joints` in degrees, sliding ones in mm. Throws Error{Usage}: not as many joints as the
// robot has, one not finite.
std::string forwardJson(const RobotModel& robot, const std::vector<double>& joints);

// {"solutions": [[q1, ..., qn], ...]}: all branches inside the limits, each joint as near to zero
// as whole turns allow, in degrees, sliding ones in mm; an empty list where the pose is out of
// reach. `pose` is x, y, z, qw, qx, qy, qz (mm; the quaternion is normalised). Throws Error{Usage}:
// not seven finite numbers, a quaternion whose length is not 1 within 1 %.
std::string inverseJson(const RobotModel& robot, const std::vector<double>& pose);

} // namespace voluta::robot
