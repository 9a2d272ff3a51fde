// Orientations as three angles about the fixed axes z, y, x: R = Rz(a) Ry(b) Rx(c). KUKA's A, B, C
// and Epson's U, V, W.
#pragma once

#include <Eigen/Geometry>

namespace voluta::program {

// Degrees, a and c in (-180, 180], b in [-90, 90]. Where b is a quarter turn, c is 0.
Eigen::Vector3d zyxDegrees(const Eigen::Quaterniond& q);
Eigen::Quaterniond rotationOfZyx(const Eigen::Vector3d& degrees);

// Position, mm, and those angles.
Eigen::Isometry3d poseOfZyx(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees);

} // namespace voluta::program
