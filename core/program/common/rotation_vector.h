// Rotation vectors (axis times angle, rad), as URScript writes orientations.
#pragma once

#include <Eigen/Geometry>

namespace voluta::program {

// The rotation vector of `q` (unit) with angle in [0, pi].
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& q);

// The rotation vector of `q` nearest to `previous` among the one above and the one that turns the
// other way round about the same axis, the latter up to 1.5 pi: a slowly turning pose has a
// continuous vector where it passes half a turn.
Eigen::Vector3d rotationVectorNear(const Eigen::Quaterniond& q, const Eigen::Vector3d& previous);

// The rotation of any vector.
Eigen::Quaterniond rotationOf(const Eigen::Vector3d& rotationVector);

} // namespace voluta::program
