// The turn from one direction to another. It stands apart since what it takes (a singular value
// decomposition, where the two are opposite) costs a compiler seconds in every file.
#pragma once

#include <Eigen/Geometry>

namespace voluta::geometry {

// By the least angle; of opposite directions about any axis across them. Neither is zero.
Eigen::Quaterniond leastTurn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace voluta::geometry
