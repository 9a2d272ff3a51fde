// Section of a laid bead: a rectangle with half-round ends (Castelli 2.1.1).
#pragma once

#include "base/units.h"

namespace voluta::process {

// 1 - pi/4: what the round ends lack of the rectangle, per height squared.
inline constexpr double kRoundLoss = 1.0 - base::kPi / 4.0;

// mm2. Preconditions: 0 < height <= width.
constexpr double beadArea(double widthMm, double heightMm) {
  return widthMm * heightMm - kRoundLoss * heightMm * heightMm;
}
// mm3 of a straight piece whose section goes evenly from one area to another.
constexpr double beadVolume(double fromMm2, double toMm2, double lengthMm) {
  return 0.5 * (fromMm2 + toMm2) * lengthMm;
}
// Distance of neighbouring beads at which their overlap fills the gaps between their round ends:
// hatch * height = area. mm.
constexpr double hatchOf(double widthMm, double heightMm) {
  return widthMm - kRoundLoss * heightMm;
}
// Inverse of hatchOf in the width: for tests that lay beads a hatch apart.
constexpr double widthOfHatch(double hatchMm, double heightMm) {
  return hatchMm + kRoundLoss * heightMm;
}
// Width of the bead of a given section area. Precondition: height > 0.
constexpr double widthOfArea(double areaMm2, double heightMm) {
  return areaMm2 / heightMm + kRoundLoss * heightMm;
}

} // namespace voluta::process
