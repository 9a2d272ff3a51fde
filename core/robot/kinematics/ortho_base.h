// The first three joints of most arms: axis 1, axes 2 and 3 parallel and across it, and a fourth
// axis across the third. The position of a point on axis 4 determines joints 1-3, in at most four
// ways: the base of ortho-parallel arms (Brandstoetter 2014, as in
// robot/kinematics/opw_kinematics.h), with the origin of the frame at the nearest points of axes 1
// and 2.
#pragma once

#include "robot/kinematics/serial_chain.h"

#include <optional>
#include <vector>

namespace voluta::robot {

// Tolerances for directions [rad] and places [mm] of axes. Descriptions round right angles to
// 1.5708 and lengths to a tenth of a millimetre.
inline constexpr double kAxisAngleRad = 1e-4, kAxisPlaceMm = 0.02;

bool parallel(const AxisLine& a, const AxisLine& b); // Same or opposite direction
bool across(const AxisLine& a, const AxisLine& b);   // Directions at a right angle
// The nearest point on each axis to the other. Precondition: not parallel.
struct NearestPoints {
  Eigen::Vector3d onA, onB;
};
NearestPoints nearestPoints(const AxisLine& a, const AxisLine& b);
// Returns the intersection; nullopt if the axes are parallel or skew.
std::optional<Eigen::Vector3d> meetingPoint(const AxisLine& a, const AxisLine& b);

// In the arm's frame axis 1 is z and axis 2, at zero, y. With theta1 = theta2 = theta3 = 0 the arm
// is upright: shoulder (axis 2) at (a1, *, 0), elbow (axis 3) c2 above it, the wrist's point (a2,
// b, c3) from it, axis 4 along z.
struct OrthoBase {
  Eigen::Isometry3d base_T_arm = Eigen::Isometry3d::Identity();
  double a1 = 0, a2 = 0, b = 0, c2 = 0, c3 = 0; // [mm]; c2 > 0, c3 >= 0
  double theta2AtZero = 0, theta3AtZero = 0;    // [rad]; theta1 is 0 at zero
  double sign3 = 1, sign4 = 1; // -1: the chain's axis is opposite to axis 2, to the forearm
};
// `wrist`: a point on axis 4, in the base frame at zero. Returns nullopt if the arm is not of this
// kind or has a link of no length. Precondition: four axes or more.
std::optional<OrthoBase> orthoBaseOf(const std::vector<AxisLine>& axes,
                                     const Eigen::Vector3d& wrist);

} // namespace voluta::robot
