// Directions in space: the angle between two, and many spread evenly.
#pragma once

#include "base/units.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::geometry {

// 0 .. pi, exact for small angles too. Lengths do not matter; neither is zero.
inline double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  if (a == b)
    return 0.0;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The n-th unit vector of a spiral that goes round by the golden angle from one to the next. With
// z, in [-1, 1], in even steps they are spread evenly over the sphere, or the zone that z spans.
inline Eigen::Vector3d onSpiral(int n, double z) {
  const double golden = base::kPi * (3.0 - std::sqrt(5.0));
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(golden * n), r * std::sin(golden * n), z};
}

} // namespace voluta::geometry
