// Principal axes of a set of points.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voluta::geometry {

// Columns: orthonormal, the direction of smallest spread first; signs are arbitrary. Precondition:
// at least one point.
Eigen::Matrix3d principalAxes(const std::vector<Eigen::Vector3d>& points);

} // namespace voluta::geometry
