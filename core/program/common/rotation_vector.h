// Rotation vectors (axis times angle, rad), the orientations of URScript.
#pragma once

#include <Eigen/Geometry>

namespace voluta::program {

// Returns the rotation vector of `q` (unit) with its angle in [0, pi].
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& q);

// Returns the rotation vector of `q` nearest to `previous`: the one above, or the rotation in the
// opposite direction about the same axis, by up to 1.5 pi. A slowly turning pose thus has a
// continuous vector when it passes half a turn.
Eigen::Vector3d rotationVectorNear(const Eigen::Quaterniond& q, const Eigen::Vector3d& previous);

// Returns the rotation of any vector.
Eigen::Quaterniond rotationOf(const Eigen::Vector3d& rotationVector);

} // namespace voluta::program
