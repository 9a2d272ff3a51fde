#include "robot/urdf/arm_recognition.h"

#include "base/error.h"
#include "robot/cell/joint_reading.h"
#include "robot/kinematics/bent_wrist.h"
#include "robot/kinematics/numeric_inverse.h"
#include "robot/kinematics/opw_kinematics.h"
#include "robot/kinematics/ortho_base.h"
#include "robot/kinematics/ur_kinematics.h"

#include <array>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Isometry3d pose(const Matrix3d& rotation, const Vector3d& at) {
  Isometry3d t = Isometry3d::Identity();
  t.linear() = rotation;
  t.translation() = at;
  return t;
}

// The family's joint is signs * (the chain's joint) + the family's value at the chain's zero.
JointReading readingOf(const std::array<double, 6>& signs, const std::array<double, 6>& atZero) {
  JointReading reading;
  for (std::size_t i = 0; i < 6; ++i) {
    reading.signs.push_back(signs[i]);
    reading.offsets.push_back(-signs[i] * atZero[i]);
  }
  return reading;
}

// Returns an arm that uses a family's kinematics, placed between the base and flange poses of the
// chain. `zero`: the flange of the family's arm in the family's frame when the chain is at zero.
RecognisedArm asFamily(ArmKind kind, std::shared_ptr<const Kinematics> family, JointReading reading,
                       const Isometry3d& base_T_arm, const Isometry3d& zero,
                       const Isometry3d& base_T_flangeAtZero) {
  const auto read = std::make_shared<ReadKinematics>(std::move(family), std::move(reading));
  const Isometry3d arm_T_base = base_T_arm.inverse();
  const Isometry3d flange_T_armFlange = base_T_flangeAtZero.inverse() * base_T_arm * zero;
  return {kind, [read, arm_T_base, flange_T_armFlange](const Isometry3d& base_T_flange,
                                                       std::vector<JointVector>& solutions) {
            read->inverse(arm_T_base * base_T_flange * flange_T_armFlange, solutions);
          }};
}

std::optional<RecognisedArm> sphericalWrist(const SerialChain& chain,
                                            const std::vector<AxisLine>& axes) {
  const std::optional<Vector3d> wrist = meetingPoint(axes[3], axes[4]),
                                other = meetingPoint(axes[4], axes[5]);
  if (!wrist || !other || (*wrist - *other).norm() > kAxisPlaceMm || !across(axes[3], axes[4]) ||
      !across(axes[4], axes[5]))
    return std::nullopt;
  const std::optional<OrthoBase> base = orthoBaseOf(axes, *wrist);
  if (!base)
    return std::nullopt;
  const Isometry3d arm_T_base = base->base_T_arm.inverse();
  const auto inArm = [&](std::size_t axis) {
    return Vector3d(arm_T_base.linear() * axes[axis].direction);
  };
  const double theta23 = base->theta2AtZero + base->theta3AtZero;
  const Vector3d x3(std::cos(theta23), 0, -std::sin(theta23)), y = Vector3d::UnitY();
  const Vector3d forearm(std::sin(theta23), 0, std::cos(theta23));
  const Vector3d fifth = inArm(4), sixth = inArm(5);
  const Vector3d x4 = fifth.cross(forearm);
  const double theta4 = std::atan2(-fifth.dot(x3), fifth.dot(y));
  const double theta5 = std::atan2(sixth.dot(x4), sixth.dot(forearm));
  Matrix3d last;
  last << fifth.cross(sixth), fifth, sixth;
  // The flange is placed at the wrist's point; the chain adds the distance from there.
  const OpwGeometry geometry{base->a1, base->a2, base->b, 0.0, base->c2, base->c3, 0.0, {}};
  return asFamily(ArmKind::SphericalWrist, std::make_shared<OpwKinematics>(geometry),
                  readingOf({1, 1, base->sign3, base->sign4, 1, 1},
                            {0, base->theta2AtZero, base->theta3AtZero, theta4, theta5, 0}),
                  base->base_T_arm, pose(last, arm_T_base * *wrist),
                  chainFlange(chain, JointVector::Zero(6)));
}

std::optional<RecognisedArm> parallelAxes(const SerialChain& chain,
                                          const std::vector<AxisLine>& axes) {
  const std::optional<Vector3d> shoulder = meetingPoint(axes[0], axes[1]),
                                first = meetingPoint(axes[3], axes[4]),
                                second = meetingPoint(axes[4], axes[5]);
  if (!shoulder || !first || !second || !across(axes[0], axes[1]) || !parallel(axes[1], axes[2]) ||
      !parallel(axes[1], axes[3]) || !across(axes[3], axes[4]) || !across(axes[4], axes[5]))
    return std::nullopt;
  // In the family's frame, axis 1 is z and, at theta1 = 0, axis 2 is -y, "across" the arm.
  Matrix3d rotation;
  rotation.col(2) = axes[0].direction;
  rotation.col(1) =
      -(axes[1].direction - axes[1].direction.dot(rotation.col(2)) * rotation.col(2)).normalized();
  rotation.col(0) = rotation.col(1).cross(rotation.col(2));
  const Isometry3d base_T_arm = pose(rotation, *shoulder);
  const Isometry3d arm_T_base = base_T_arm.inverse();
  const auto inArm = [&](const Vector3d& point) { return Vector3d(arm_T_base * point); };
  const auto sign = [&](std::size_t axis) {
    return axes[axis].direction.dot(axes[1].direction) < 0.0 ? -1.0 : 1.0;
  };
  const Vector3d elbow = inArm(axes[2].point), wrist = inArm(axes[3].point), p45 = inArm(*first),
                 p56 = inArm(*second);
  const double a2 = std::hypot(elbow.x(), elbow.z());
  const double a3 = std::hypot(wrist.x() - elbow.x(), wrist.z() - elbow.z());
  constexpr double kNoLinkMm = 1.0;
  if (a2 < kNoLinkMm || a3 < kNoLinkMm)
    return std::nullopt;
  const double theta2 = std::atan2(elbow.z(), elbow.x());
  const double theta23 = std::atan2(wrist.z() - elbow.z(), wrist.x() - elbow.x());
  const Vector3d down = rotation.transpose() * axes[4].direction, across(0, -1, 0);
  const Vector3d sixth = rotation.transpose() * axes[5].direction;
  const double theta234 = std::atan2(down.x(), -down.z());
  const Vector3d forward(std::cos(theta234), 0, std::sin(theta234));
  const double theta5 = std::atan2(-sixth.dot(forward), sixth.dot(across));
  // The family requires a length along axis 6; the flange's pose compensates it.
  constexpr double kLastMm = 1.0;
  const UrGeometry geometry{0.0, a2, a3, -p45.y(), (p56 - p45).dot(down), kLastMm};
  const double s3 = sign(2), s4 = sign(3);
  Matrix3d last;
  last << -down.cross(sixth), -down, sixth;
  return asFamily(
      ArmKind::ParallelAxes, std::make_shared<UrKinematics>(geometry),
      readingOf({1, 1, s3, s4, 1, 1}, {0, theta2, theta23 - theta2, theta234 - theta23, theta5, 0}),
      base_T_arm, pose(last, p56 + kLastMm * sixth), chainFlange(chain, JointVector::Zero(6)));
}

} // namespace

RecognisedArm recognisedArm(const SerialChain& chain) {
  base::require(chain.joints.size() == 6, "an arm of six axes");
  const std::vector<AxisLine> axes = axesAtZero(chain);
  if (auto arm = sphericalWrist(chain, axes))
    return *std::move(arm);
  if (auto arm = parallelAxes(chain, axes))
    return *std::move(arm);
  if (auto arm = BentWrist::of(chain))
    return {ArmKind::BentWrist, [solver = *std::move(arm)](const Isometry3d& pose_,
                                                           std::vector<JointVector>& solutions) {
              solver.inverse(pose_, solutions);
            }};
  auto solver = std::make_shared<NumericInverse>(chain);
  return {ArmKind::Other, [solver](const Isometry3d& pose_, std::vector<JointVector>& solutions) {
            solver->inverse(pose_, solutions);
          }};
}

} // namespace voluta::robot
