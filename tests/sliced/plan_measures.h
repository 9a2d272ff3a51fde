// Length and volume of all beads of a plan.
#pragma once

#include "plan/tool_plan.h"
#include "process/bead_to.h"

#include <cstddef>

namespace voluta::test {

inline double lengthOf(const plan::ToolPlan& plan) {
  double length = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      length += (plan.position[i] - plan.position[i - 1]).norm();
  return length;
}

inline double volumeOf(const plan::ToolPlan& plan) {
  double volume = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      volume += process::beadTo(plan, i);
  return volume;
}

} // namespace voluta::test
