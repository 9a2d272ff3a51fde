// A target of a motion, and targets between two of them.
#pragma once

#include "base/units.h"

#include <Eigen/Geometry>
#include <cmath>

namespace voluta::replay {

// A TCP pose in Base, a pose of the nozzle in the work frame, or the nozzle's tip and direction
// there.
struct MotionTarget {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

// Returns the target at share u of the straight motion from `a` to `b`.
inline MotionTarget between(const MotionTarget& a, const MotionTarget& b, double u) {
  MotionTarget t;
  t.position = a.position + u * (b.position - a.position);
  t.rotation = a.rotation.slerp(u, b.rotation);
  const double angle =
      std::atan2(a.direction.cross(b.direction).norm(), a.direction.dot(b.direction));
  if (angle < 1e-9 || angle > base::kPi - 1e-9)
    t.direction = u < 0.5 ? a.direction : b.direction;
  else
    t.direction = (std::sin((1 - u) * angle) * a.direction + std::sin(u * angle) * b.direction) /
                  std::sin(angle);
  t.direction.normalize();
  return t;
}

// Returns the number of chords of an arc that stay within 0.002 mm of it. `in`, `out`: directions
// at its ends.
inline double chordsOfArc(double lengthMm, const Eigen::Vector3d& in, const Eigen::Vector3d& out) {
  constexpr double kSagittaMm = 0.002;
  const double rotation = std::atan2(in.cross(out).norm(), in.dot(out));
  return std::sqrt(lengthMm * rotation / (8.0 * kSagittaMm));
}

} // namespace voluta::replay
