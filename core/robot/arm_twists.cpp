#include "robot/arm_twists.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kProbeRad = 0.5, kProbeMm = 10.0; // far enough that rounding hardly counts
constexpr double kNoTwist = 1e-9;
constexpr double kThereMm = 1e-9, kThereRad = 1e-12;
constexpr int kSteps = 8;
constexpr double kReachMm = 300.0; // what a rad counts beside mm in a step

// The sine of the turn from `is` to `wanted` along its axis; of a small one the turn itself.
Vector3d smallTurn(const Matrix3d& wanted, const Matrix3d& is) {
  return 0.5 * (is.col(0).cross(wanted.col(0)) + is.col(1).cross(wanted.col(1)) +
                is.col(2).cross(wanted.col(2)));
}

} // namespace

ArmTwists::ArmTwists(const Kinematics& kinematics) : kinematics_(kinematics) {
  const Eigen::Index dof = kinematics.dof();
  std::vector<Isometry3d> rest, moved;
  kinematics.linkPoses(JointVector::Zero(dof), rest);
  for (Eigen::Index j = 0; j < dof; ++j) {
    const bool slides = kinematics.kindOf(static_cast<int>(j)) == JointKind::Sliding;
    const double probe = slides ? kProbeMm : kProbeRad;
    JointVector q = JointVector::Zero(dof);
    q[j] = probe;
    kinematics.linkPoses(q, moved);
    for (std::size_t k = 1; k < rest.size(); ++k) {
      const Isometry3d before = rest[k - 1].inverse(Eigen::Isometry) * rest[k];
      const Isometry3d after = moved[k - 1].inverse(Eigen::Isometry) * moved[k];
      const Isometry3d step = before.inverse(Eigen::Isometry) * after; // exp of the screw
      const Eigen::AngleAxisd angle(step.linear());
      Twist t{k, j, step.translation() / probe, Vector3d::Zero()};
      if (angle.angle() > kNoTwist) {
        // translation = (1 - R) point + pitch: of a turn about a line through `point`.
        t.turn = angle.angle() * angle.axis() / probe;
        const Vector3d w = angle.axis();
        const double half = 0.5 * angle.angle();
        const Vector3d along = w.dot(step.translation()) * w, across = step.translation() - along;
        t.velocity = (along + half / std::tan(half) * across - half * w.cross(across)) / probe;
      }
      if (t.velocity.norm() > kNoTwist || t.turn.norm() > kNoTwist)
        twists_.push_back(t);
    }
  }
}

ArmJacobian ArmTwists::jacobian(const JointVector& q, Isometry3d& base_T_flange,
                                std::vector<Isometry3d>& links) const {
  kinematics_.linkPoses(q, links);
  base_T_flange = links.back();
  ArmJacobian jacobian = ArmJacobian::Zero(6, kinematics_.dof());
  for (const Twist& t : twists_) {
    const Isometry3d& link = links[t.link];
    const Vector3d turn = link.linear() * t.turn;
    jacobian.col(t.joint).head<3>() +=
        link.linear() * t.velocity + turn.cross(base_T_flange.translation() - link.translation());
    jacobian.col(t.joint).tail<3>() += turn;
  }
  return jacobian;
}

bool ArmTwists::follow(const Isometry3d& wanted, double longestStep, JointVector& q,
                       ArmJacobian& at, std::vector<Isometry3d>& links) const {
  const Eigen::Index dof = kinematics_.dof();
  Isometry3d is;
  for (int n = 0; n < kSteps; ++n) {
    at = jacobian(q, is, links);
    Vector6d error;
    error << wanted.translation() - is.translation(), smallTurn(wanted.linear(), is.linear());
    if (error.head<3>().norm() < kThereMm && error.tail<3>().norm() < kThereRad)
      return (wanted.linear() - is.linear()).norm() < 1e-6; // and not half a turn off
    const JointVector step = jointsFor(at, error, kReachMm);
    for (Eigen::Index j = 0; j < dof; ++j)
      if (!(std::abs(asTurn(kinematics_.kindOf(static_cast<int>(j)), step[j])) <= longestStep))
        return false;
    q.head(dof) += step;
  }
  return false;
}

JointVector jointsFor(const ArmJacobian& jacobian, const Vector6d& twist, double lengthMm) {
  ArmJacobian scaled = jacobian;
  scaled.topRows<3>() /= lengthMm;
  Vector6d wanted = twist;
  wanted.head<3>() /= lengthMm;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 8, 8> normal =
      scaled.transpose() * scaled;
  normal.diagonal().array() += 1e-14;
  const JointVector right = scaled.transpose() * wanted;
  return normal.llt().solve(right);
}

} // namespace voluta::robot
