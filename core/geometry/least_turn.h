// The smallest rotation from one direction to another.
#pragma once

#include <Eigen/Geometry>

namespace voluta::geometry {

// For opposite directions the axis is any perpendicular one. Precondition: neither is zero.
Eigen::Quaterniond shortestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace voluta::geometry
