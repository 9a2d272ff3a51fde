// Orientations as three angles about the fixed axes: R = Rz(c) Ry(b) Rx(a). MELFA-BASIC's A, B, C
// and TMscript's Rx, Ry, Rz are (a, b, c); KUKA's A, B, C and Epson's U, V, W are (c, b, a)
// (docs/programs.md, One rotation in every convention).
#pragma once

#include <Eigen/Geometry>

namespace voluta::program {

// Returns (a, b, c) of `q` [rad]; a and c in [-pi, pi], b in [-pi/2, pi/2]. If b is a right angle,
// only a - c or a + c is defined: a is 0.
Eigen::Vector3d xyzAngles(const Eigen::Quaterniond& q);

// Returns the angles of `q` nearest to `previous`, so that a slowly turning pose has continuous
// angles.
Eigen::Vector3d xyzAnglesNear(const Eigen::Quaterniond& q, const Eigen::Vector3d& previous);

// Returns the rotation of any angles.
Eigen::Quaterniond rotationOfXyz(const Eigen::Vector3d& angles);

// (c, b, a), degrees.
Eigen::Vector3d zyxDegrees(const Eigen::Quaterniond& q);
Eigen::Quaterniond rotationOfZyx(const Eigen::Vector3d& degrees);
// Position [mm] and the angles above.
Eigen::Isometry3d poseOfZyx(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees);

} // namespace voluta::program
