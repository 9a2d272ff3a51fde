// A rotation as three angles that a user types, without surprises.
#pragma once

#include <Eigen/Geometry>

namespace voluta::geometry {

// Turns about the fixed X, then Y, then Z axis of the work frame by radians.
Eigen::Quaterniond rotationOf(const Eigen::Vector3d& anglesXyz);

// Angles of `rotation`, in (-pi, pi]; of the many triples the one nearest to `near`, so that what
// the user typed stays as typed, also where the middle angle is a right one.
Eigen::Vector3d anglesOf(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& near);

} // namespace voluta::geometry
