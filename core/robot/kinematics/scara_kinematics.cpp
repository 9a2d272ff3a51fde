#include "robot/kinematics/scara_kinematics.h"

#include "base/error.h"
#include "robot/angles.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

// Tolerance [cosine of joint 2]: a pose out of reach by less is accepted as rounding.
constexpr double kElbowSlack = 2e-11;

Eigen::Isometry3d turnedAt(double x, double y, double z, double angle) {
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  t.translation() = Eigen::Vector3d(x, y, z);
  const double c = std::cos(angle), s = std::sin(angle);
  t.linear() << c, -s, 0, s, c, 0, 0, 0, 1;
  return t;
}

} // namespace

ScaraKinematics::ScaraKinematics(const ScaraGeometry& geometry) : g_(geometry) {
  base::require(g_.a1 > 0.0 && g_.a2 > 0.0, "a SCARA with a bar of no length");
}

void ScaraKinematics::linkPoses(const JointVector& q,
                                std::vector<Eigen::Isometry3d>& base_T_link) const {
  base::require(q.size() >= 4, "a SCARA has four joints");
  base_T_link.resize(6);
  auto& t = base_T_link;
  const double x = g_.a1 * std::cos(q[0]), y = g_.a1 * std::sin(q[0]), both = q[0] + q[1];
  const double xEnd = x + g_.a2 * std::cos(both), yEnd = y + g_.a2 * std::sin(both);
  t[0].setIdentity();
  t[1] = turnedAt(0.0, 0.0, 0.0, q[0]);
  t[2] = turnedAt(x, y, 0.0, both);
  t[3] = turnedAt(xEnd, yEnd, g_.top + q[2], both);
  t[4] = turnedAt(xEnd, yEnd, g_.top + q[2], both + q[3]);
  t[5] = t[4];
}

Eigen::Isometry3d ScaraKinematics::flange(const JointVector& q) const {
  base::require(q.size() >= 4, "a SCARA has four joints");
  const double both = q[0] + q[1];
  return turnedAt(g_.a1 * std::cos(q[0]) + g_.a2 * std::cos(both),
                  g_.a1 * std::sin(q[0]) + g_.a2 * std::sin(both), g_.top + q[2], both + q[3]);
}

void ScaraKinematics::inverse(const Eigen::Isometry3d& base_T_flange,
                              std::vector<JointVector>& solutions) const {
  const auto& r = base_T_flange.linear();
  if (r(2, 2) <= 0.0 || std::hypot(r(0, 2), r(1, 2)) > kUprightFlangeRad)
    return;
  const double u = std::atan2(r(1, 0) - r(0, 1), r(0, 0) + r(1, 1));
  const double x = base_T_flange.translation().x(), y = base_T_flange.translation().y();
  const double c2 = (x * x + y * y - g_.a1 * g_.a1 - g_.a2 * g_.a2) / (2.0 * g_.a1 * g_.a2);
  if (std::abs(c2) > 1.0 + kElbowSlack)
    return;
  const double cosine = std::clamp(c2, -1.0, 1.0);
  const double bend = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  for (int elbow = 0; elbow < (bend > 0.0 ? 2 : 1); ++elbow) {
    const double sine = elbow == 0 ? bend : -bend;
    const double k = g_.a1 + g_.a2 * cosine, m = g_.a2 * sine;
    // (x, y) = (k, m) rotated by theta1.
    const double theta1 = wrappedAngle(std::atan2(y * k - x * m, x * k + y * m));
    const double theta2 = wrappedAngle(std::atan2(sine, cosine));
    JointVector q(4);
    q << theta1, theta2, base_T_flange.translation().z() - g_.top,
        wrappedAngle(u - theta1 - theta2);
    solutions.push_back(q);
  }
}

} // namespace voluta::robot
