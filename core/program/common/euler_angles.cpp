#include "program/common/euler_angles.h"

#include "base/units.h"

#include <cmath>

namespace voluta::program {

Eigen::Vector3d xyzAngles(const Eigen::Quaterniond& q) {
  constexpr double kUpright = 1e-9; // cos b below which a and c rotate about the same axis
  const Eigen::Matrix3d r = q.normalized().toRotationMatrix();
  const double level = std::hypot(r(0, 0), r(1, 0)), b = std::atan2(-r(2, 0), level);
  if (level < kUpright)
    return {0.0, b, std::atan2(-r(0, 1), r(1, 1))};
  return {std::atan2(r(2, 1), r(2, 2)), b, std::atan2(r(1, 0), r(0, 0))};
}

Eigen::Vector3d xyzAnglesNear(const Eigen::Quaterniond& q, const Eigen::Vector3d& previous) {
  const auto near = [&](Eigen::Vector3d angles) {
    for (int k = 0; k < 3; ++k)
      angles[k] += base::kTwoPi * std::round((previous[k] - angles[k]) / base::kTwoPi);
    return angles;
  };
  const Eigen::Vector3d direct = xyzAngles(q);
  const Eigen::Vector3d one = near(direct);
  const Eigen::Vector3d other =
      near({direct.x() + base::kPi, base::kPi - direct.y(), direct.z() + base::kPi});
  return (other - previous).squaredNorm() < (one - previous).squaredNorm() ? other : one;
}

Eigen::Quaterniond rotationOfXyz(const Eigen::Vector3d& angles) {
  return (Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()))
      .normalized();
}

Eigen::Vector3d zyxDegrees(const Eigen::Quaterniond& q) {
  return xyzAngles(q).reverse().unaryExpr([](double rad) { return base::radiansToDegrees(rad); });
}

Eigen::Quaterniond rotationOfZyx(const Eigen::Vector3d& degrees) {
  return rotationOfXyz(
      degrees.reverse().unaryExpr([](double degree) { return base::degreesToRadians(degree); }));
}

Eigen::Isometry3d poseOfZyx(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotationOfZyx(degrees).toRotationMatrix();
  pose.translation() = mm;
  return pose;
}

} // namespace voluta::program
