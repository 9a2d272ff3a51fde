// Kinds of joints, the units of their values, and how steps of different kinds compare.
#pragma once

#include "base/units.h"

#include <cstdint>

namespace voluta::robot {

enum class JointKind : std::uint8_t { Turning, Sliding };

// Displacement of a sliding joint that counts as a rotation of one radian wherever steps of joints
// are compared: a typical lever of a rotating joint.
inline constexpr double kSlideMmPerRad = 100.0;

// Converts a joint step [rad] or [mm] to an equivalent rotation [rad], or back; speeds and
// accelerations likewise.
constexpr double asAngle(JointKind kind, double step) {
  return kind == JointKind::Sliding ? step / kSlideMmPerRad : step;
}
constexpr double fromAngle(JointKind kind, double rad) {
  return kind == JointKind::Sliding ? rad * kSlideMmPerRad : rad;
}

// Converts a joint's value to display units [degrees] or [mm], or back; speeds and accelerations
// likewise.
constexpr double shownValue(JointKind kind, double value) {
  return kind == JointKind::Sliding ? value : base::radiansToDegrees(value);
}
constexpr double ofShownValue(JointKind kind, double shown) {
  return kind == JointKind::Sliding ? shown : base::degreesToRadians(shown);
}

} // namespace voluta::robot
