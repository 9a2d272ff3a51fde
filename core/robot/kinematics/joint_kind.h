// What joints do, in which units their values are told, and how much a step of one counts beside
// another's.
#pragma once

#include "base/units.h"

#include <cstdint>

namespace voluta::robot {

enum class JointKind : std::uint8_t { Turning, Sliding };

// A slide of so much counts as a turn of one rad wherever steps of joints are held against each
// other: what a turning joint moves lies about so far from its axis.
inline constexpr double kSlideMmPerRad = 100.0;

// A step of a joint, rad or mm, as a turn, rad; speeds and accelerations likewise. And back.
constexpr double asTurn(JointKind kind, double step) {
  return kind == JointKind::Sliding ? step / kSlideMmPerRad : step;
}
constexpr double fromTurn(JointKind kind, double rad) {
  return kind == JointKind::Sliding ? rad * kSlideMmPerRad : rad;
}

// A joint's value as people read it, degrees or mm; speeds and accelerations likewise. And back.
constexpr double shownValue(JointKind kind, double value) {
  return kind == JointKind::Sliding ? value : base::radiansToDegrees(value);
}
constexpr double ofShownValue(JointKind kind, double shown) {
  return kind == JointKind::Sliding ? shown : base::degreesToRadians(shown);
}

} // namespace voluta::robot
