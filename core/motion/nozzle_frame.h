// Tool poses for a tip and a direction, carried along paths with minimum rotation.
#pragma once

#include "geometry/least_turn.h"

#include <Eigen/Geometry>
#include <cmath>

namespace voluta::motion {

// Returns the orientation of the tool frame (z = -direction) reached from `last` by the smallest
// rotation.
inline Eigen::Quaterniond carried(const Eigen::Quaterniond& last,
                                  const Eigen::Vector3d& direction) {
  const Eigen::Vector3d now = -(last * Eigen::Vector3d::UnitZ());
  return (geometry::shortestRotation(now, direction) * last).normalized();
}

// Returns the initial orientation: upright, x along the work frame's x.
inline Eigen::Quaterniond uprightTool() {
  return Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0); // Half a turn about x: z down
}

inline Eigen::Quaterniond turned(const Eigen::Quaterniond& tool, double angle) {
  return tool * Eigen::Quaterniond(std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle));
}

inline Eigen::Isometry3d toolPose(const Eigen::Vector3d& tip, const Eigen::Quaterniond& tool) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = tool.toRotationMatrix();
  pose.translation() = tip;
  return pose;
}

// Returns the rotation angle between two orientations, 0 .. pi.
inline double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double c = std::min(1.0, std::abs(a.dot(b)));
  const double s = (a.coeffs() - (a.dot(b) < 0.0 ? -1.0 : 1.0) * b.coeffs()).norm();
  return c > 0.9 ? 4.0 * std::asin(std::min(1.0, 0.5 * s)) : 2.0 * std::acos(c);
}

} // namespace voluta::motion
