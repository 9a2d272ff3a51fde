// Writes points, poses and shapes as in the files of robots and cells, for robot/cell/json_pose.h
// and robot/cell/shape_reader.h.
#pragma once

#include "robot/body.h"

#include <nlohmann/json_fwd.hpp>

namespace voluta::robot {

// Returns the value without rounding noise such as 90.00000000000001.
double tidy(double value);

nlohmann::ordered_json vectorJson(const Eigen::Vector3d& v);
nlohmann::ordered_json degreesJson(double rad);
nlohmann::ordered_json poseJson(const Eigen::Isometry3d& pose);
// Precondition: not a prism, which files cannot contain.
nlohmann::ordered_json shapeJson(const Shape& shape);
nlohmann::ordered_json shapesJson(const std::vector<Shape>& shapes);

} // namespace voluta::robot
