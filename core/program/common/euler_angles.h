// Orientations as three angles about the fixed axes: R = Rz(c) Ry(b) Rx(a). MELFA-BASIC's A, B, C
// and TMscript's Rx, Ry, Rz are (a, b, c); KUKA's A, B, C and Epson's U, V, W the same from behind
// (docs/programs.md, One rotation in every convention).
#pragma once

#include <Eigen/Geometry>

namespace voluta::program {

// (a, b, c) of `q`, radians; a and c in [-pi, pi], b in [-pi/2, pi/2]. Where b is a right angle
// only a - c or a + c has a meaning: a is 0.
Eigen::Vector3d xyzAngles(const Eigen::Quaterniond& q);

// Of all angles of `q` those nearest to `previous`: a slowly turning pose has continuous angles.
Eigen::Vector3d xyzAnglesNear(const Eigen::Quaterniond& q, const Eigen::Vector3d& previous);

// The rotation of any angles.
Eigen::Quaterniond rotationOfXyz(const Eigen::Vector3d& angles);

// (c, b, a), degrees.
Eigen::Vector3d zyxDegrees(const Eigen::Quaterniond& q);
Eigen::Quaterniond rotationOfZyx(const Eigen::Vector3d& degrees);
// Position, mm, and those angles.
Eigen::Isometry3d poseOfZyx(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees);

} // namespace voluta::program
