#include "pipeline/avoided.h"

#include "base/error.h"
#include "plan/waypoints.h"

namespace voluta::pipeline {

std::vector<std::size_t> Avoided::next(const plan::ToolPlan& plan,
                                       const std::vector<std::size_t>& met) {
  std::set<std::size_t> fresh;
  const auto leaveOut = [&](std::size_t waypoint) {
    if (!all_.contains(waypoint))
      fresh.insert(waypoint);
  };
  for (const std::size_t waypoint : met) {
    leaveOut(waypoint);
    if (!fresh.contains(waypoint))
      continue;
    const plan::ToolPath* path = plan::pathOf(plan, waypoint);
    base::require(path != nullptr, "a waypoint of the plan");
    const std::size_t last = path->first + path->count - 1;
    if (waypoint > path->first && all_.contains(waypoint - 1))
      for (std::size_t k = 1; k <= beyond_ && waypoint + k <= last; ++k)
        leaveOut(waypoint + k);
    if (waypoint < last && all_.contains(waypoint + 1))
      for (std::size_t k = 1; k <= beyond_ && waypoint >= path->first + k; ++k)
        leaveOut(waypoint - k);
  }
  beyond_ = 2 * beyond_ + 1;
  all_.insert(fresh.begin(), fresh.end());
  return {fresh.begin(), fresh.end()};
}

} // namespace voluta::pipeline
