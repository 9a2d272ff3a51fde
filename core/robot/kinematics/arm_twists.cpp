#include "robot/kinematics/arm_twists.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kProbeRad = 0.5, kProbeMm = 10.0; // Large enough that rounding is negligible
constexpr double kNoTwist = 1e-9;
constexpr double kLastStep = 3e-6; // [rad]; the remaining error is of the order of its square
constexpr int kSteps = 8;
constexpr double kSingular = 1e-14; // Damping that bounds the step at a singular pose
constexpr double kReachMm = 300.0;  // Length that makes a radian comparable to mm in a step
// Determinant with lengths divided by kReachMm: about the smallest significant angle
constexpr double kNoSide = 1e-9;

// Returns the axis of the rotation from `is` to `wanted`, scaled by the sine of its angle; for a
// small rotation, the rotation vector.
Vector3d smallRotation(const Matrix3d& wanted, const Matrix3d& is) {
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
      const Isometry3d step = before.inverse(Eigen::Isometry) * after; // Exponential of the screw
      const Eigen::AngleAxisd angle(step.linear());
      Twist t{k, j, step.translation() / probe, Vector3d::Zero()};
      if (angle.angle() > kNoTwist) {
        // For a rotation about a line through `point`: translation = (1 - R) point + pitch.
        t.rotation = angle.angle() * angle.axis() / probe;
        const Vector3d w = angle.axis();
        const double half = 0.5 * angle.angle();
        const Vector3d along = w.dot(step.translation()) * w, across = step.translation() - along;
        t.velocity = (along + half / std::tan(half) * across - half * w.cross(across)) / probe;
      }
      if (t.velocity.norm() > kNoTwist || t.rotation.norm() > kNoTwist)
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
    const Vector3d rotation = link.linear() * t.rotation;
    jacobian.col(t.joint).head<3>() +=
        link.linear() * t.velocity +
        rotation.cross(base_T_flange.translation() - link.translation());
    jacobian.col(t.joint).tail<3>() += rotation;
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
    error << wanted.translation() - is.translation(), smallRotation(wanted.linear(), is.linear());
    const JointVector step = jointsFor(at, error, kReachMm);
    double longest = 0.0;
    for (Eigen::Index j = 0; j < dof; ++j)
      longest =
          std::max(longest, std::abs(asAngle(kinematics_.kindOf(static_cast<int>(j)), step[j])));
    if (!(longest <= longestStep))
      return false;
    q.head(dof) += step;
    if (longest <= kLastStep) // At half a turn the error vanishes too
      return (wanted.linear() - is.linear()).norm() < 1e-3;
  }
  return false;
}

int ArmTwists::singularSide(const JointVector& q, std::vector<Isometry3d>& links) const {
  if (kinematics_.dof() != 6)
    return 0;
  Isometry3d flange;
  Eigen::Matrix<double, 6, 6> square = jacobian(q, flange, links);
  square.topRows<3>() /= kReachMm;
  const double determinant = square.determinant();
  return (determinant > kNoSide) - (determinant < -kNoSide);
}

namespace {

template <int kDof, typename Joints, typename Twists>
Joints solved(const ArmJacobian& jacobian, Twists twists, double lengthMm) {
  Eigen::Matrix<double, 6, kDof, Eigen::ColMajor, 6, kDof == Eigen::Dynamic ? 8 : kDof> scaled =
      jacobian;
  scaled.template topRows<3>() /= lengthMm;
  twists.template topRows<3>() /= lengthMm;
  Eigen::Matrix<double, kDof, kDof, Eigen::ColMajor, kDof == Eigen::Dynamic ? 8 : kDof,
                kDof == Eigen::Dynamic ? 8 : kDof>
      normal = scaled.transpose().lazyProduct(scaled);
  normal.diagonal().array() += kSingular;
  return normal.llt().solve(scaled.transpose().lazyProduct(twists));
}

template <typename Joints, typename Twists>
Joints solvedFor(const ArmJacobian& jacobian, const Twists& twists, double lengthMm) {
  return jacobian.cols() == 6 ? solved<6, Joints>(jacobian, twists, lengthMm)
                              : solved<Eigen::Dynamic, Joints>(jacobian, twists, lengthMm);
}

} // namespace

JointVector jointsFor(const ArmJacobian& jacobian, const Vector6d& twist, double lengthMm) {
  return solvedFor<JointVector>(jacobian, twist, lengthMm);
}

JointRates jointsFor(const ArmJacobian& jacobian, const ArmTwistSet& twists, double lengthMm) {
  return solvedFor<JointRates>(jacobian, twists, lengthMm);
}

} // namespace voluta::robot
