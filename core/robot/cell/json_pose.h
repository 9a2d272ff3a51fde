// Reads points and poses in descriptions of robots and cells.
#pragma once

#include "base/json_node.h"

#include <Eigen/Geometry>

namespace voluta::robot {

// Both throw Error{UnusableInput} as base::JsonNode. [x, y, z]
Eigen::Vector3d readVector3(const base::JsonNode& node);
// {"xyzMm": [x, y, z], "rpyDeg": [r, p, y]}: R = Rz(y) Ry(p) Rx(r), as in URDF; rpyDeg is optional.
Eigen::Isometry3d readPose(const base::JsonNode& node);

} // namespace voluta::robot
