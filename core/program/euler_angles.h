// Angles about x, y and z, as MELFA-BASIC (A, B, C) and TMscript (Rx, Ry, Rz) write orientations:
// R = Rz(c) Ry(b) Rx(a) (docs/programs.md, One rotation in every convention).
#pragma once

#include <Eigen/Geometry>

namespace voluta::program {

// (a, b, c) of `q` (unit), radians; a and c in [-pi, pi], b in [-pi/2, pi/2]. Where b is a right
// angle only a - c or a + c has a meaning: a is 0.
Eigen::Vector3d xyzAngles(const Eigen::Quaterniond& q);

// Of all angles of `q` those nearest to `previous`: a slowly turning pose has continuous angles.
Eigen::Vector3d xyzAnglesNear(const Eigen::Quaterniond& q, const Eigen::Vector3d& previous);

// The rotation of any angles.
Eigen::Quaterniond rotationOfXyz(const Eigen::Vector3d& angles);

} // namespace voluta::program
