// Volume of the beads of a plan.
#pragma once

#include "plan/tool_plan.h"
#include "process/bead_model.h"

#include <cstddef>

namespace voluta::process {

// Returns the volume [mm3] of the bead from the previous waypoint to this one. Precondition: both
// are of one path that lays a bead (no shot, no tape).
inline double beadTo(const plan::ToolPlan& plan, std::size_t waypoint) {
  const auto section = [&](std::size_t i) {
    return beadArea(static_cast<double>(plan.widthMm[i]), static_cast<double>(plan.heightMm[i]));
  };
  return beadVolume(section(waypoint - 1), section(waypoint),
                    (plan.position[waypoint] - plan.position[waypoint - 1]).norm());
}

} // namespace voluta::process
