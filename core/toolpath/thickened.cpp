#include "toolpath/thickened.h"

#include "base/error.h"
#include "process/bead_model.h"
#include "toolpath/bridges.h"

#include <algorithm>

namespace voluta::toolpath {

void thickenHanging(plan::ToolPlan& plan, std::vector<char>& hanging,
                    const collision::GrowingPart& part, const process::Process& process) {
  base::require(hanging.size() == plan.waypointCount(), "a mark for each waypoint");
  const double step = 0.25 * part.grid().pitch;
  for (const plan::ToolPath& path : plan.paths)
    for (const HangingStretch& s : hangingStretches(plan, path, hanging, 0.5 * process.bridgeMm))
      for (std::size_t i = s.begin; i < s.end; ++i) {
        const auto height = static_cast<double>(plan.heightMm[i]);
        const Eigen::Vector3d bottom = plan.position[i] - height * plan.direction[i];
        const double most = process.layerHeightMaxMm - height;
        double depth = 0.5 * step;
        while (depth <= most && !part.holds(bottom - depth * plan.direction[i], i))
          depth += step;
        if (depth > most)
          continue;
        const double thicker = height + depth - 0.5 * step;
        plan.heightMm[i] = static_cast<float>(thicker);
        const double section = process::beadArea(static_cast<double>(plan.widthMm[i]), thicker);
        plan.speedMmPerS[i] =
            std::min(plan.speedMmPerS[i], static_cast<float>(process.maxFlowMm3PerS / section));
        hanging[i] = 0;
      }
}

} // namespace voluta::toolpath
