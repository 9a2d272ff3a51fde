// Internal units are mm, radians and seconds; other units are used only in readers, writers and
// forms.
#pragma once

#include <numbers>

namespace voluta::base {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2.0 * kPi; // A full turn

constexpr double degreesToRadians(double degrees) {
  return degrees * kPi / 180.0;
}
constexpr double radiansToDegrees(double radians) {
  return radians * 180.0 / kPi;
}

} // namespace voluta::base
