#include "program/euler_angles.h"

#include "base/units.h"

#include <cmath>

namespace voluta::program {

Eigen::Vector3d xyzAngles(const Eigen::Quaterniond& q) {
  const Eigen::Matrix3d r = q.toRotationMatrix();
  const double cosine = std::hypot(r(0, 0), r(1, 0)), b = std::atan2(-r(2, 0), cosine);
  if (cosine < 1e-9)
    return {0.0, b, std::atan2(-r(0, 1), r(1, 1))};
  return {std::atan2(r(2, 1), r(2, 2)), b, std::atan2(r(1, 0), r(0, 0))};
}

Eigen::Vector3d xyzAnglesNear(const Eigen::Quaterniond& q, const Eigen::Vector3d& previous) {
  const auto near = [&](Eigen::Vector3d angles) {
    for (int k = 0; k < 3; ++k)
      angles[k] += 2.0 * base::kPi * std::round((previous[k] - angles[k]) / (2.0 * base::kPi));
    return angles;
  };
  const Eigen::Vector3d direct = xyzAngles(q);
  const Eigen::Vector3d one = near(direct);
  const Eigen::Vector3d other =
      near({direct.x() + base::kPi, base::kPi - direct.y(), direct.z() + base::kPi});
  return (other - previous).squaredNorm() < (one - previous).squaredNorm() ? other : one;
}

Eigen::Quaterniond rotationOfXyz(const Eigen::Vector3d& angles) {
  return Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX());
}

} // namespace voluta::program
