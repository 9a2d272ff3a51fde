// Lateral changes of a stretch of a path that fade out before and after it.
#pragma once

#include "plan/tool_plan.h"
#include "toolpath/unsupported/bridges.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace voluta::toolpath {

// The amount at each waypoint of a stretch to one side (-1, 1), > 0 where it helps. Side 0: it
// helps nowhere.
struct LateralOffset {
  int side = 0;
  std::vector<double> amounts;
};
// Returns the offsets to the side on which minAmount(waypoint, side) helps at more waypoints; left
// wins ties.
template <typename MinAmount>
LateralOffset betterSide(const UnsupportedStretch& s, const MinAmount& minAmount) {
  LateralOffset best;
  std::ptrdiff_t maximum = 0;
  for (const int side : {-1, 1}) {
    std::vector<double> amounts(s.end - s.begin);
    for (std::size_t i = s.begin; i < s.end; ++i)
      amounts[i - s.begin] = minAmount(i, side);
    const auto helped = std::ranges::count_if(amounts, [](double a) { return a > 0.0; });
    if (helped > maximum) {
      maximum = helped;
      best = {side, std::move(amounts)};
    }
  }
  return best;
}

// Returns the next waypoint of a path, wrapping around on closed paths; at the end of an open path
// the same waypoint.
inline std::size_t nextOf(const plan::ToolPath& path, std::size_t i, bool forwards) {
  const std::size_t last = path.first + path.count - 1;
  if (forwards)
    return i < last ? i + 1 : path.closed ? path.first + 1 : i;
  return i > path.first ? i - 1 : path.closed ? last - 1 : i;
}

// Calls take(waypoint, amount) for the stretch and, in both directions along the path, until
// `amounts` (>= 0, of the stretch's waypoints) have faded to zero, by `perMm` per mm of path. A
// waypoint can be passed twice.
template <typename Take>
void taperAlongPath(const plan::ToolPlan& plan, const plan::ToolPath& path,
                    const UnsupportedStretch& s, const std::vector<double>& amounts, double perMm,
                    const Take& take) {
  for (const bool forwards : {true, false}) {
    double amount = 0.0;
    std::size_t i = forwards ? s.begin : s.end - 1;
    for (std::size_t done = 0; done < path.count; ++done) {
      const bool inside = i >= s.begin && i < s.end;
      amount = std::max(inside ? amounts[i - s.begin] : 0.0, amount);
      if (amount <= 0.0 && !inside)
        break;
      take(i, std::max(0.0, amount));
      const std::size_t next = nextOf(path, i, forwards);
      if (next == i)
        break;
      amount -= perMm * (plan.position[next] - plan.position[i]).norm();
      i = next;
    }
  }
}

} // namespace voluta::toolpath
