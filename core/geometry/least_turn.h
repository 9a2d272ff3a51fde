// The turn from one direction to another.
#pragma once

#include <Eigen/Geometry>

namespace voluta::geometry {

// By the least angle; of opposite directions about any axis across them. Neither is zero.
Eigen::Quaterniond leastTurn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace voluta::geometry
