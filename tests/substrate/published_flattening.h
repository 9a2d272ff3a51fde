// The published rule of flattening circles (Castelli 2020, 5.2.3); plans use flatteningToPlane().
#pragma once

#include "substrate/flatten.h"

#include <cmath>
#include <vector>

namespace voluta::test {

// Returns `layers` + 1 circles from `start` outwards. Each layer is topMm thick at the top and
// sideMm at the polar angle sideAngle of the circle below it (radians from the horizontal, in
// (0, pi/2)), measured along that circle's radius. Precondition: such circles exist.
inline std::vector<substrate::FlatteningCircle>
flatteningCircles(const substrate::FlatteningCircle& start, double topMm, double sideMm,
                  double sideAngle, int layers) {
  std::vector<substrate::FlatteningCircle> circles{start};
  for (int k = 0; k < layers; ++k) {
    const double r = circles.back().radiusMm;
    const double over = sideMm * sideMm + 2.0 * r * (sideMm - topMm) - topMm * topMm;
    const double under = 2.0 * (r + topMm) - 2.0 * (r + sideMm) * std::sin(sideAngle);
    circles.push_back({circles.back().topMm + topMm, r + topMm + over / under});
  }
  return circles;
}

} // namespace voluta::test
