// Small tilts of nozzle directions: their amount, the cone they are limited to, and the tool
// orientation that results.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace voluta::motion {

// A lean is a rotation about an axis across the nozzle, as a vector of the tool's x and y; its
// length [rad] is the angle between the new direction and the tool's own.
inline Eigen::Quaterniond leant(const Eigen::Quaterniond& tool, const Eigen::Vector2d& lean) {
  const double half = 0.5 * lean.norm();
  const double sine = half < 1e-9 ? 0.5 : std::sin(half) / (2.0 * half);
  return tool * Eigen::Quaterniond(std::cos(half), sine * lean.x(), sine * lean.y(), 0.0);
}

// Returns the angular rate of the leant tool, in its own axes, per change of its lean: one column
// per component of the lean (the right Jacobian of rotations: Lynch and Park, Modern Robotics,
// 3.2.3).
inline Eigen::Matrix<double, 3, 2> leanRates(const Eigen::Vector2d& lean) {
  const double angle = lean.norm();
  const bool none = angle < 1e-4;
  const double a = none ? 0.5 : (1.0 - std::cos(angle)) / (angle * angle);
  const double b = none ? 1.0 / 6.0 : (angle - std::sin(angle)) / (angle * angle * angle);
  const double x = lean.x(), y = lean.y();
  Eigen::Matrix<double, 3, 2> rates; // 1 - a [lean] + b [lean]^2
  rates << 1.0 - b * y * y, b * x * y, b * x * y, 1.0 - b * x * x, a * y, -a * x;
  return rates;
}

// The leans shorter than `rad`, parametrised by two unbounded numbers.
struct LeanCone {
  double rad = 0.0;

  Eigen::Vector2d at(const Eigen::Vector2d& free) const {
    return rad / std::sqrt(1.0 + free.squaredNorm()) * free;
  }
  // at(free) == lean. Precondition: lean is within the cone.
  Eigen::Vector2d freeOf(const Eigen::Vector2d& lean) const {
    return lean / std::sqrt(rad * rad - lean.squaredNorm());
  }
  // Derivative of the lean by `free`.
  Eigen::Matrix2d slope(const Eigen::Vector2d& free) const {
    const double s = 1.0 / std::sqrt(1.0 + free.squaredNorm());
    return rad * s * (Eigen::Matrix2d::Identity() - s * s * free * free.transpose());
  }
};

} // namespace voluta::motion
