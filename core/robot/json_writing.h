// Points, poses and shapes as descriptions of robots and cells have them (robot/json_pose.h,
// robot/shape_reader.h). Read back they are the same but for rounding in the last places of turns.
#pragma once

#include "robot/body.h"

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>

namespace voluta::robot {

// Without what rounding leaves behind: 90.00000000000001.
double tidy(double value);

nlohmann::ordered_json vectorJson(const Eigen::Vector3d& v);
nlohmann::ordered_json degreesJson(double rad);
nlohmann::ordered_json poseJson(const Eigen::Isometry3d& pose);
// Precondition: no prism, which files cannot hold.
nlohmann::ordered_json shapeJson(const Shape& shape);

} // namespace voluta::robot
