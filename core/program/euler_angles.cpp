#include "program/euler_angles.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

Eigen::Vector3d zyxDegrees(const Eigen::Quaterniond& q) {
  constexpr double kUpright = 1e-9; // cos b below which a and c turn about one axis
  const Eigen::Matrix3d r = q.normalized().toRotationMatrix();
  const double level = std::hypot(r(0, 0), r(1, 0));
  const double b = std::atan2(-r(2, 0), level);
  double a = 0.0, c = 0.0;
  if (level > kUpright) {
    a = std::atan2(r(1, 0), r(0, 0));
    c = std::atan2(r(2, 1), r(2, 2));
  } else {
    a = std::atan2(-r(0, 1), r(1, 1));
  }
  return {base::radiansToDegrees(a), base::radiansToDegrees(b), base::radiansToDegrees(c)};
}

Eigen::Quaterniond rotationOfZyx(const Eigen::Vector3d& degrees) {
  const auto about = [](double degree, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(base::degreesToRadians(degree), axis);
  };
  return Eigen::Quaterniond(about(degrees[0], Eigen::Vector3d::UnitZ()) *
                            about(degrees[1], Eigen::Vector3d::UnitY()) *
                            about(degrees[2], Eigen::Vector3d::UnitX()))
      .normalized();
}

Eigen::Isometry3d poseOfZyx(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotationOfZyx(degrees).toRotationMatrix();
  pose.translation() = mm;
  return pose;
}

} // namespace voluta::program
