#include "geometry/turn_angles.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::geometry {

namespace {
using base::kPi;

// In (-pi, pi].
double wrapped(double angle) {
  const double turned = std::remainder(angle, 2.0 * kPi);
  return turned <= -kPi ? turned + 2.0 * kPi : turned;
}

double distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
    sum += std::abs(wrapped(a[i] - b[i]));
  return sum;
}
} // namespace

Eigen::Quaterniond rotationOf(const Eigen::Vector3d& angles) {
  return Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX());
}

Eigen::Vector3d anglesOf(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& near) {
  if (rotation.angularDistance(rotationOf(near)) < 1e-9)
    return {wrapped(near.x()), wrapped(near.y()), wrapped(near.z())};
  const Eigen::Matrix3d r = rotation.normalized().toRotationMatrix();
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  const double y = std::atan2(-r(2, 0), cosine);
  if (cosine < 1e-7) {
    // Gimbal lock, X and Z rotate about the same line: keep the displayed X, Z takes the rest.
    const double x = near.x();
    const double sign = y > 0.0 ? 1.0 : -1.0;
    const double together = std::atan2(-r(0, 1), r(1, 1)); // z - sign * x
    return {wrapped(x), y, wrapped(together + sign * x)};
  }
  const Eigen::Vector3d first(std::atan2(r(2, 1), r(2, 2)), y, std::atan2(r(1, 0), r(0, 0)));
  const Eigen::Vector3d second(first.x() + kPi, kPi - y, first.z() + kPi);
  const Eigen::Vector3d& nearest = distance(first, near) <= distance(second, near) ? first : second;
  return {wrapped(nearest.x()), wrapped(nearest.y()), wrapped(nearest.z())};
}

} // namespace voluta::geometry
