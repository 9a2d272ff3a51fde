// The axes along which points are spread.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voluta::geometry {

// Columns: unit, at right angles to each other, the direction of least spread first; their sense is
// any. Precondition: points.
Eigen::Matrix3d principalAxes(const std::vector<Eigen::Vector3d>& points);

} // namespace voluta::geometry
