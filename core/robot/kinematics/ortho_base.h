// The first three joints of most arms: axis 1, axes 2 and 3 parallel and across it, and a fourth
// axis that turns across the third. Where a point on axis 4 is, says joints 1-3, four ways at most:
// the base of ortho-parallel arms (Brandstoetter 2014, as in robot/kinematics/opw_kinematics.h),
// with the frame moved to where axes 1 and 2 are next to each other.
#pragma once

#include "robot/kinematics/serial_chain.h"

#include <optional>
#include <vector>

namespace voluta::robot {

// How exact directions (rad) and places (mm) of axes have to be for what is told of them here.
// Descriptions round right angles to 1.5708 and lengths to a tenth of a millimetre.
inline constexpr double kAxisTurnRad = 1e-4, kAxisPlaceMm = 0.02;

bool parallel(const AxisLine& a, const AxisLine& b); // or against each other
bool across(const AxisLine& a, const AxisLine& b);   // directions at a right angle
// Where the two come next to each other, on each. Precondition: not parallel.
struct NearestPoints {
  Eigen::Vector3d onA, onB;
};
NearestPoints nearestPoints(const AxisLine& a, const AxisLine& b);
// Where they meet. None: parallel, or apart.
std::optional<Eigen::Vector3d> meetingPoint(const AxisLine& a, const AxisLine& b);

// In the arm's frame axis 1 is z and axis 2, at zero, y. With theta1 = theta2 = theta3 = 0 the arm
// stands upright: shoulder (axis 2) at (a1, *, 0), elbow (axis 3) c2 above it, the wrist's point
// (a2, b, c3) from it, axis 4 along z.
struct OrthoBase {
  Eigen::Isometry3d base_T_arm = Eigen::Isometry3d::Identity();
  double a1 = 0, a2 = 0, b = 0, c2 = 0, c3 = 0; // mm; c2 > 0, c3 >= 0
  double theta2AtZero = 0, theta3AtZero = 0;    // rad; theta1 is 0 at zero
  double sign3 = 1, sign4 = 1; // -1: the chain's axis runs against axis 2, against the forearm
};
// `wrist`: a point on axis 4, in the base's frame at zero. None: no such arm, or one with a link of
// no length. Precondition: four axes or more.
std::optional<OrthoBase> orthoBaseOf(const std::vector<AxisLine>& axes,
                                     const Eigen::Vector3d& wrist);

} // namespace voluta::robot
