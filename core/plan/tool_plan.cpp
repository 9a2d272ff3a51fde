#include "plan/tool_plan.h"

#include <algorithm>

namespace voluta::plan {

bool ToolPlan::isSolid() const {
  return std::all_of(fill.begin(), fill.end(), [](const FillIntent& f) { return f.isSolid(); });
}

double ToolPlan::shotMm3(const ToolPath& path) const {
  const std::size_t at = shotAt(path);
  constexpr double kQuarterPi = 0.78539816339744831;
  const auto width = static_cast<double>(widthMm[at]);
  return kQuarterPi * width * width * static_cast<double>(heightMm[at]);
}

std::size_t ToolPlan::shotAt(const ToolPath& path) const {
  std::size_t lowest = path.first;
  for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
    if ((position[i] - position[lowest]).dot(direction[path.first]) < 0.0)
      lowest = i;
  return lowest;
}

std::size_t ToolPlan::firstAfter(const Insert& insert) const {
  const auto path = std::ranges::find_if(paths, [&](const ToolPath& one) {
    return one.item == insert.item && one.layer >= insert.layer && !isWaste(one.kind);
  });
  return path == paths.end() ? waypointCount() : path->first;
}

bool ToolPlan::isPrimeInAir() const {
  constexpr double kOnMm = 0.01;
  return primes() && position[paths.front().first].z() >
                         static_cast<double>(heightMm[paths.front().first]) + kOnMm;
}

} // namespace voluta::plan
