// Joint angles as inverses give them.
#pragma once

#include "base/units.h"

#include <cmath>

namespace voluta::robot {

// The same turn in (-pi, pi].
inline double wrappedAngle(double angle) {
  const double rest = std::remainder(angle, base::kTurn);
  return rest <= -base::kPi ? base::kPi : rest;
}

} // namespace voluta::robot
