#include "program/common/rotation_vector.h"

#include "base/units.h"

#include <cmath>

namespace voluta::program {

Eigen::Vector3d rotationVector(const Eigen::Quaterniond& q) {
  const double sine = q.vec().norm();
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  if (sine < 1e-12)
    return 2.0 * sign * q.vec();
  return (2.0 * sign * std::atan2(sine, std::abs(q.w())) / sine) * q.vec();
}

Eigen::Vector3d rotationVectorNear(const Eigen::Quaterniond& q, const Eigen::Vector3d& previous) {
  const Eigen::Vector3d direct = rotationVector(q);
  const double angle = direct.norm();
  if (angle < 0.5 * base::kPi)
    return direct;
  const Eigen::Vector3d around = direct * ((angle - 2.0 * base::kPi) / angle);
  return (around - previous).squaredNorm() < (direct - previous).squaredNorm() ? around : direct;
}

Eigen::Quaterniond rotationOf(const Eigen::Vector3d& rotationVector) {
  const double angle = rotationVector.norm();
  // Series of sin(x)/x where the quotient loses digits.
  const double half = angle < 1e-6 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  Eigen::Quaterniond q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = half * rotationVector;
  return q.normalized();
}

} // namespace voluta::program
