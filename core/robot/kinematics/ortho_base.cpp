#include "robot/kinematics/ortho_base.h"

#include "base/error.h"

#include <cmath>

namespace voluta::robot {

using Eigen::Vector3d;

bool parallel(const AxisLine& a, const AxisLine& b) {
  return a.direction.cross(b.direction).norm() < kAxisAngleRad;
}

bool across(const AxisLine& a, const AxisLine& b) {
  return std::abs(a.direction.dot(b.direction)) < kAxisAngleRad;
}

NearestPoints nearestPoints(const AxisLine& a, const AxisLine& b) {
  const Vector3d between = b.point - a.point;
  const double cosine = a.direction.dot(b.direction);
  const double onA = between.dot(a.direction), onB = between.dot(b.direction);
  const double square = 1.0 - cosine * cosine;
  base::require(square > 0.0, "nearest points of axes that are parallel");
  return {a.point + (onA - cosine * onB) / square * a.direction,
          b.point + (cosine * onA - onB) / square * b.direction};
}

std::optional<Vector3d> meetingPoint(const AxisLine& a, const AxisLine& b) {
  if (parallel(a, b))
    return std::nullopt;
  const NearestPoints nearest = nearestPoints(a, b);
  if ((nearest.onA - nearest.onB).norm() > kAxisPlaceMm)
    return std::nullopt;
  return 0.5 * (nearest.onA + nearest.onB);
}

std::optional<OrthoBase> orthoBaseOf(const std::vector<AxisLine>& axes, const Vector3d& wrist) {
  base::require(axes.size() >= 4, "an arm of four axes or more");
  if (!across(axes[0], axes[1]) || !parallel(axes[1], axes[2]) || !across(axes[2], axes[3]))
    return std::nullopt;
  OrthoBase arm;
  Eigen::Matrix3d rotation;
  rotation.col(2) = axes[0].direction;
  rotation.col(1) =
      (axes[1].direction - axes[1].direction.dot(rotation.col(2)) * rotation.col(2)).normalized();
  rotation.col(0) = rotation.col(1).cross(rotation.col(2));
  arm.base_T_arm.linear() = rotation;
  arm.base_T_arm.translation() = nearestPoints(axes[0], axes[1]).onA;
  const auto inArm = [&](const Vector3d& p) { return Vector3d(arm.base_T_arm.inverse() * p); };

  const Vector3d shoulder = inArm(axes[1].point), elbow = inArm(axes[2].point),
                 point = inArm(wrist), forearm = rotation.transpose() * axes[3].direction;
  arm.a1 = shoulder.x();
  arm.b = point.y();
  arm.c2 = std::hypot(elbow.x() - shoulder.x(), elbow.z() - shoulder.z());
  arm.sign3 = axes[2].direction.dot(rotation.col(1)) < 0.0 ? -1.0 : 1.0;
  // A shorter link is not accepted: the elbow's two solutions could not be distinguished.
  constexpr double kNoLinkMm = 1.0;
  const double toWrist = std::hypot(point.x() - elbow.x(), point.z() - elbow.z());
  if (arm.c2 < kNoLinkMm || toWrist < kNoLinkMm)
    return std::nullopt;
  arm.theta2AtZero = std::atan2(elbow.x() - shoulder.x(), elbow.z() - shoulder.z());
  const double along =
      forearm.x() * (point.x() - elbow.x()) + forearm.z() * (point.z() - elbow.z());
  arm.sign4 = along < 0.0 ? -1.0 : 1.0;
  const double theta23 = std::atan2(arm.sign4 * forearm.x(), arm.sign4 * forearm.z());
  arm.theta3AtZero = theta23 - arm.theta2AtZero;
  arm.c3 = std::abs(along);
  arm.a2 =
      std::cos(theta23) * (point.x() - elbow.x()) - std::sin(theta23) * (point.z() - elbow.z());
  return arm;
}

} // namespace voluta::robot
