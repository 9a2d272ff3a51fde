// How much waits may differ from the plan.
#pragma once

#include <algorithm>

namespace voluta::replay {

// Returns how much the duration of a planned wait may differ [s].
inline double waitTolerance(double plannedS) {
  constexpr double kShare = 0.02, kMinS = 0.05;
  return std::max(kMinS, kShare * plannedS);
}

} // namespace voluta::replay
