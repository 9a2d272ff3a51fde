// Cross-section of a deposited bead: a rectangle with half-round ends (Castelli 2.1.1).
#pragma once

#include "base/units.h"

namespace voluta::process {

// 1 - pi/4: area that the round ends lack compared with the rectangle, per height squared.
inline constexpr double kRoundLoss = 1.0 - base::kPi / 4.0;

// Returns the section area [mm2]. Precondition: 0 < height <= width.
constexpr double beadArea(double widthMm, double heightMm) {
  return widthMm * heightMm - kRoundLoss * heightMm * heightMm;
}
// Returns the volume [mm3] of a straight piece whose section changes linearly from one area to
// another.
constexpr double beadVolume(double fromMm2, double toMm2, double lengthMm) {
  return 0.5 * (fromMm2 + toMm2) * lengthMm;
}
// Returns the distance [mm] of neighbouring beads at which their overlap fills the gaps between
// their round ends: hatch * height = area.
constexpr double hatchOf(double widthMm, double heightMm) {
  return widthMm - kRoundLoss * heightMm;
}
// Inverse of hatchOf for the width; used by tests that place beads a hatch apart.
constexpr double widthOfHatch(double hatchMm, double heightMm) {
  return hatchMm + kRoundLoss * heightMm;
}
// Returns the width of the bead with a given section area. Precondition: height > 0.
constexpr double widthOfArea(double areaMm2, double heightMm) {
  return areaMm2 / heightMm + kRoundLoss * heightMm;
}

} // namespace voluta::process
