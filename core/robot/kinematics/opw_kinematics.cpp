#include "robot/kinematics/opw_kinematics.h"

#include "base/error.h"
#include "robot/angles.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Below this sin(theta5) the wrist counts as singular: keeping theta4 at its offset rotates the
// flange by no more than this.
constexpr double kWristSingular = 1e-12;
// Tolerances [mm] and [cosine of the elbow]: a pose out of reach by less is accepted as rounding,
// and elbow branches closer than this count as one.
constexpr double kShoulderSlackMm = 1e-9;
constexpr double kElbowSlack = 1e-13;

Matrix3d aboutY(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d r;
  r << c, 0, s, 0, 1, 0, -s, 0, c;
  return r;
}
Matrix3d aboutZ(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d r;
  r << c, -s, 0, s, c, 0, 0, 0, 1;
  return r;
}

} // namespace

// base_R_link of links 1-6, measured from the upright arm.
struct OpwKinematics::Turns {
  std::array<Matrix3d, 6> link;
};

OpwKinematics::Turns OpwKinematics::turnsAt(const JointVector& q) const {
  const auto angle = [&](std::size_t i) { return q[static_cast<Eigen::Index>(i)] - g_.offsets[i]; };
  Turns t;
  t.link[0] = aboutZ(angle(0));
  t.link[1] = t.link[0] * aboutY(angle(1));
  t.link[2] = t.link[0] * aboutY(angle(1) + angle(2));
  t.link[3] = t.link[2] * aboutZ(angle(3));
  t.link[4] = t.link[3] * aboutY(angle(4));
  t.link[5] = t.link[4] * aboutZ(angle(5));
  return t;
}

OpwKinematics::OpwKinematics(const OpwGeometry& geometry)
    : g_(geometry), forearm_(std::hypot(g_.a2, g_.c3)), bend_(std::atan2(g_.a2, g_.c3)) {
  base::require(g_.c2 > 0.0 && forearm_ > 0.0, "ortho-parallel arm with a link of no length");
  const Turns zero = turnsAt(JointVector::Zero(6));
  for (std::size_t i = 0; i < 6; ++i)
    zeros_[i] = zero.link[i].transpose();
}

void OpwKinematics::linkPoses(const JointVector& q,
                              std::vector<Eigen::Isometry3d>& base_T_link) const {
  base::require(q.size() >= 6, "an ortho-parallel arm has six joints");
  const Turns turns = turnsAt(q);
  base_T_link.assign(8, Eigen::Isometry3d::Identity());
  auto& t = base_T_link;
  for (std::size_t i = 0; i < 6; ++i)
    t[i + 1].linear() = turns.link[i] * zeros_[i];
  t[1].translation() = Vector3d(0, 0, g_.c1);
  t[2].translation() = t[1].translation() + turns.link[0] * Vector3d(g_.a1, 0, 0);
  t[3].translation() = t[2].translation() + turns.link[1] * Vector3d(0, 0, g_.c2);
  t[4].translation() = t[3].translation() + turns.link[2] * Vector3d(g_.a2, g_.b, 0);
  t[5].translation() = t[4].translation() + turns.link[2] * Vector3d(0, 0, g_.c3);
  t[6].translation() = t[5].translation() + turns.link[5] * Vector3d(0, 0, g_.c4);
  t[7].linear() = turns.link[5];
  t[7].translation() = t[6].translation();
}

Eigen::Isometry3d OpwKinematics::flange(const JointVector& q) const {
  base::require(q.size() >= 6, "an ortho-parallel arm has six joints");
  const Turns turns = turnsAt(q);
  const double q2 = q[1] - g_.offsets[1], q23 = q2 + q[2] - g_.offsets[2];
  const double c23 = std::cos(q23), s23 = std::sin(q23);
  const Vector3d wrist(g_.a1 + g_.c2 * std::sin(q2) + g_.a2 * c23 + g_.c3 * s23, g_.b,
                       g_.c1 + g_.c2 * std::cos(q2) - g_.a2 * s23 + g_.c3 * c23);
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  t.linear() = turns.link[5];
  t.translation() = turns.link[0] * wrist + g_.c4 * turns.link[5].col(2);
  return t;
}

void OpwKinematics::inverse(const Eigen::Isometry3d& base_T_flange,
                            std::vector<JointVector>& solutions) const {
  const Matrix3d rotation = base_T_flange.linear();
  const Vector3d wrist = base_T_flange.translation() - g_.c4 * rotation.col(2);

  // Joint 1: seen from axis 1, the wrist's centre is (ahead, b) in the arm's plane and across it.
  const double reach = std::hypot(wrist.x(), wrist.y());
  if (reach < std::abs(g_.b) - kShoulderSlackMm)
    return;
  const bool onAxis = reach < kShoulderSlackMm;
  const double azimuth = onAxis ? 0.0 : std::atan2(wrist.y(), wrist.x());
  const double ahead =
      onAxis ? 0.0 : std::sqrt(std::max(0.0, (reach - std::abs(g_.b)) * (reach + std::abs(g_.b))));
  for (int shoulder = 0; shoulder < (ahead > 0.0 ? 2 : 1); ++shoulder) {
    const double along = shoulder == 0 ? ahead : -ahead;
    const double theta1 = azimuth - (onAxis ? 0.0 : std::atan2(g_.b, along));

    // Joints 2 and 3: two bars, c2 and the forearm, in the arm's plane (x ahead, z up).
    const double x = along - g_.a1, z = wrist.z() - g_.c1;
    const double cosine =
        (x * x + z * z - g_.c2 * g_.c2 - forearm_ * forearm_) / (2.0 * g_.c2 * forearm_);
    if (std::abs(cosine) > 1.0 + kElbowSlack)
      continue;
    const bool straight = std::abs(cosine) > 1.0 - kElbowSlack; // Or folded
    const double c = straight ? std::copysign(1.0, cosine) : cosine;
    const double sine = straight ? 0.0 : std::sqrt((1.0 - c) * (1.0 + c));
    for (int elbow = 0; elbow < (straight ? 1 : 2); ++elbow) {
      const double s = elbow == 0 ? sine : -sine;
      const double theta3 = std::atan2(s, c) - bend_;
      const double theta2 = std::atan2(x, z) - std::atan2(forearm_ * s, g_.c2 + forearm_ * c);

      // The wrist: m = Rz(theta4) Ry(theta5) Rz(theta6). Theta5 and theta6 are computed from the
      // rest of m after theta4, not from m's own last row: near sin(theta5) = 0 that row is
      // dominated by rounding, and theta6 must compensate an error of theta4.
      const Matrix3d m = (aboutZ(theta1) * aboutY(theta2 + theta3)).transpose() * rotation;
      const double sine5 = std::hypot(m(0, 2), m(1, 2));
      const bool singular = sine5 < kWristSingular;
      for (int flip = 0; flip < (singular ? 1 : 2); ++flip) {
        const double sign = flip == 0 ? 1.0 : -1.0;
        const double c4 = singular ? 1.0 : sign * m(0, 2) / sine5;
        const double s4 = singular ? 0.0 : sign * m(1, 2) / sine5;
        const double theta4 = std::atan2(s4, c4);
        const double theta5 = std::atan2(singular ? 0.0 : sign * sine5, m(2, 2));
        const double theta6 = std::atan2(c4 * m(1, 0) - s4 * m(0, 0), c4 * m(1, 1) - s4 * m(0, 1));
        JointVector q(6);
        q << theta1, theta2, theta3, theta4, theta5, theta6;
        for (std::size_t i = 0; i < 6; ++i) {
          double& joint = q[static_cast<Eigen::Index>(i)];
          joint = wrappedAngle(joint + g_.offsets[i]);
        }
        solutions.push_back(q);
      }
    }
  }
}

} // namespace voluta::robot
