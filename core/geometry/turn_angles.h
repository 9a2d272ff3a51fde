// Conversion between rotations and the three angles that a user enters.
#pragma once

#include <Eigen/Geometry>

namespace voluta::geometry {

// Rotations about the fixed X, then Y, then Z axis of the work frame, in radians.
Eigen::Quaterniond rotationOf(const Eigen::Vector3d& anglesXyz);

// Returns angles of `rotation`, in (-pi, pi]; of the equivalent triples the one nearest to `near`,
// so that the angles that the user entered stay as entered, also if the middle one is a right
// angle.
Eigen::Vector3d anglesOf(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& near);

} // namespace voluta::geometry
