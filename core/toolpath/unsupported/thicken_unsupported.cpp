#include "toolpath/unsupported/thicken_unsupported.h"

#include "base/error.h"
#include "base/run_context.h"
#include "collision/growing_part.h"
#include "process/bead_model.h"
#include "toolpath/unsupported/bridges.h"

#include <algorithm>
#include <array>
#include <vector>

namespace voluta::toolpath {

namespace {

// Returns how much thicker each bead of a stretch has to be [mm]; 0 if it would exceed the maximum.
std::vector<double> reachDown(const plan::ToolPlan& plan, const UnsupportedStretch& s,
                              const collision::GrowingPart& part, double thickestMm) {
  const double step = 0.25 * part.grid().pitch;
  std::vector<double> by(s.end - s.begin, 0.0);
  for (std::size_t i = s.begin; i < s.end; ++i) {
    const auto height = static_cast<double>(plan.heightMm[i]);
    const Eigen::Vector3d bottom = plan.position[i] - height * plan.direction[i];
    const double maximum = thickestMm - height;
    for (double depth = 0.5 * step; depth <= maximum; depth += step)
      if (part.holds(bottom - depth * plan.direction[i], i)) {
        by[i - s.begin] = depth - 0.5 * step;
        break;
      }
  }
  return by;
}

// Median of three: depths measured in the grid jitter by half a cell. Drops isolated waypoints.
std::vector<double> steadied(const std::vector<double>& by) {
  std::vector<double> result(by.size(), 0.0);
  for (std::size_t k = 0; k < by.size(); ++k) {
    std::array<double, 3> three{k > 0 ? by[k - 1] : 0.0, by[k],
                                k + 1 < by.size() ? by[k + 1] : 0.0};
    std::ranges::sort(three);
    result[k] = three[1];
  }
  return result;
}

} // namespace

std::optional<PassResult> thickenUnsupported(const UnsupportedBeads& beads, const SeenPart& part,
                                             const PassScene& scene, const base::RunContext& ctx) {
  const plan::ToolPlan& was = beads.plan;
  base::require(beads.unsupported.size() == was.waypointCount(), "a mark for each waypoint");
  std::optional<PassResult> out;
  for (const plan::ToolPath& path : was.paths) {
    ctx.checkpoint();
    const process::Process& process = scene.tooling.of(path).process;
    for (const UnsupportedStretch& s :
         unsupportedStretches(was, path, beads.unsupported, 0.5 * process.bridgeMm)) {
      const std::vector<double> by = steadied(reachDown(was, s, part(), process.layerHeightMaxMm));
      for (std::size_t i = s.begin; i < s.end; ++i) {
        if (by[i - s.begin] <= 0.0)
          continue;
        if (!out)
          out.emplace(PassResult{beads});
        plan::ToolPlan& plan = out->beads.plan;
        const double thicker = std::min(process.layerHeightMaxMm,
                                        static_cast<double>(was.heightMm[i]) + by[i - s.begin]);
        plan.heightMm[i] = static_cast<float>(thicker);
        const double section = process::beadArea(static_cast<double>(was.widthMm[i]), thicker);
        plan.speedMmPerS[i] =
            std::min(was.speedMmPerS[i], static_cast<float>(process::flowLimit(process) / section));
        out->beads.unsupported[i] = 0;
      }
    }
  }
  return out;
}

} // namespace voluta::toolpath
