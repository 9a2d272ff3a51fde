// Angle between two directions; evenly distributed directions.
#pragma once

#include "base/units.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::geometry {

// Returns the angle in [0, pi], accurate for small angles too. Vectors need not be normalized, but
// must not be zero.
inline double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  if (a == b)
    return 0.0;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Returns the n-th unit vector of a spiral whose azimuth advances by the golden angle. With z in
// even steps within [-1, 1], the vectors are evenly distributed over the sphere, or over the zone
// that z spans.
inline Eigen::Vector3d onSpiral(int n, double z) {
  const double golden = base::kPi * (3.0 - std::sqrt(5.0));
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(golden * n), r * std::sin(golden * n), z};
}

} // namespace voluta::geometry
