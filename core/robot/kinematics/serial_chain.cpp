#include "robot/kinematics/serial_chain.h"

#include "base/error.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kDoneMm = 1e-10, kDoneRad = 1e-13;
constexpr double kLongestStepRad = 0.7;

Isometry3d turned(const ChainJoint& joint, double q) {
  Isometry3d t = joint.link_T_joint;
  t.linear() *= Eigen::AngleAxisd(q, joint.axis).toRotationMatrix();
  return t;
}

// Returns the rotation vector from `is` to `wanted`.
Vector3d rotationTo(const Eigen::Matrix3d& wanted, const Eigen::Matrix3d& is) {
  const Eigen::Matrix3d r = wanted * is.transpose();
  const Vector3d twice(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  const double sine = 0.5 * twice.norm(), cosine = 0.5 * (r.trace() - 1.0);
  if (sine < 1e-8 && cosine > 0.0)
    return 0.5 * twice;
  if (sine < 1e-6) { // Half a turn: `twice` does not contain the axis
    const Eigen::AngleAxisd rotation(r);
    return rotation.angle() * rotation.axis();
  }
  return (0.5 * std::atan2(sine, cosine) / sine) * twice;
}

struct Step {
  Eigen::Matrix<double, 6, 6> jacobian;
  Eigen::Matrix<double, 6, 1> error; // [mm], then [rad]
  double lengthMm;                   // Length that makes a radian comparable to mm
};

Step stepAt(const SerialChain& chain, const Isometry3d& wanted, const JointVector& q) {
  std::array<Vector3d, 6> points, axes;
  Isometry3d t = Isometry3d::Identity();
  for (std::size_t i = 0; i < 6; ++i) {
    t = t * turned(chain.joints[i], q[static_cast<Eigen::Index>(i)]);
    points[i] = t.translation();
    axes[i] = t.linear() * chain.joints[i].axis;
  }
  t = t * chain.last_T_flange;
  Step step;
  step.lengthMm = 1.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector3d lever = axes[i].cross(t.translation() - points[i]);
    step.jacobian.col(static_cast<Eigen::Index>(i)) << lever, axes[i];
    step.lengthMm = std::max(step.lengthMm, lever.norm());
  }
  step.error << wanted.translation() - t.translation(), rotationTo(wanted.linear(), t.linear());
  return step;
}

} // namespace

std::vector<AxisLine> axesAtZero(const SerialChain& chain) {
  std::vector<AxisLine> axes;
  Isometry3d t = Isometry3d::Identity();
  for (const ChainJoint& joint : chain.joints) {
    t = t * joint.link_T_joint;
    axes.push_back({t.translation(), t.linear() * joint.axis});
  }
  return axes;
}

void chainPoses(const SerialChain& chain, const JointVector& q,
                std::vector<Isometry3d>& base_T_link) {
  base::require(q.size() >= static_cast<Eigen::Index>(chain.joints.size()),
                "as many joints as the arm has");
  base_T_link.assign(1, Isometry3d::Identity());
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    base_T_link.push_back(base_T_link.back() *
                          turned(chain.joints[i], q[static_cast<Eigen::Index>(i)]));
  base_T_link.push_back(base_T_link.back() * chain.last_T_flange);
}

Isometry3d chainFlange(const SerialChain& chain, const JointVector& q) {
  base::require(q.size() >= static_cast<Eigen::Index>(chain.joints.size()),
                "as many joints as the arm has");
  Isometry3d t = Isometry3d::Identity();
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    t = t * turned(chain.joints[i], q[static_cast<Eigen::Index>(i)]);
  return t * chain.last_T_flange;
}

PoseError poseError(const Isometry3d& is, const Isometry3d& wanted) {
  return {(wanted.translation() - is.translation()).norm(),
          (wanted.linear() - is.linear()).norm() / std::sqrt(2.0)};
}

PoseError settle(const SerialChain& chain, const Isometry3d& base_T_flange, int steps,
                 JointVector& q) {
  base::require(chain.joints.size() == 6 && q.size() == 6, "settle: six joints");
  JointVector at = q;
  PoseError best{0.0, 0.0};
  double minimum = 0.0;
  for (int n = 0;; ++n) {
    Step step = stepAt(chain, base_T_flange, at);
    const PoseError error{step.error.head<3>().norm(), step.error.tail<3>().norm()};
    step.error.head<3>() /= step.lengthMm;
    step.jacobian.topRows<3>() /= step.lengthMm;
    const double size = step.error.squaredNorm();
    if (n == 0 || size < minimum) {
      minimum = size;
      best = error;
      q = at;
    }
    if (n == steps || (error.mm < kDoneMm && error.rad < kDoneRad))
      return best;
    Eigen::Matrix<double, 6, 6> normal = step.jacobian.transpose() * step.jacobian;
    normal.diagonal().array() += 1e-3 * size + 1e-18;
    Eigen::Matrix<double, 6, 1> move = normal.ldlt().solve(step.jacobian.transpose() * step.error);
    const double longest = move.cwiseAbs().maxCoeff();
    if (!std::isfinite(longest))
      return best;
    if (longest > kLongestStepRad)
      move *= kLongestStepRad / longest;
    at += move;
  }
}

} // namespace voluta::robot
