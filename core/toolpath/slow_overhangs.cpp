#include "toolpath/slow_overhangs.h"

#include "base/index.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "toolpath/feature_speeds.h"
#include "toolpath/plane/contours.h"
#include "toolpath/plane/level_patches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::toolpath {

namespace {
using base::at;

constexpr std::size_t kSteps = 8;
constexpr double kUnseen = 0.06; // Smaller shares of the width are none

// The areas over a layer in which the middle of a bead has at most some overhang. They are made
// when they are asked for: most walls have none.
class OverhangZones {
public:
  OverhangZones(const ClipperLib::Paths& below, double widthMm)
      : below_(below), widthMm_(widthMm), zones_(kSteps) {}

  double overhangAt(const Eigen::Vector2d& place) {
    std::size_t step = 0;
    while (step < kSteps && !zone(step).contains(place))
      ++step;
    return static_cast<double>(step) / kSteps;
  }

private:
  const Contours& zone(std::size_t step) {
    constexpr double kArcMm = 0.02;
    if (!zones_[step]) {
      const double share = static_cast<double>(step) / kSteps + (step == 0 ? kUnseen : 0.0);
      zones_[step].emplace(geometry::offsetPaths(below_, (share - 0.5) * widthMm_, {kArcMm}));
    }
    return *zones_[step];
  }

  const ClipperLib::Paths& below_;
  double widthMm_;
  std::vector<std::optional<Contours>> zones_;
};

bool isSlowed(const plan::ToolPath& path, const process::Tooling& tooling) {
  return path.kind == plan::PathKind::Wall && path.patch >= 0 &&
         tooling.of(path).process.overhangSpeed != process::OverhangSpeed();
}

double usualSpeed(const plan::ToolPath& path, const process::Process& process) {
  const double own = process.features.of(featureOf(path)).speedMmPerS;
  return own > 0.0 ? own : process.speedMmPerS;
}
} // namespace

void slowOverhangs(plan::ToolPlan& plan, const layers::LayerStack& stack,
                   const process::Tooling& tooling, const base::RunContext& ctx) {
  constexpr double kWidthStepMm = 0.01;            // Widths that differ by less are one
  std::map<int, std::vector<std::size_t>> ofPatch; // paths
  for (std::size_t p = 0; p < plan.paths.size(); ++p)
    if (isSlowed(plan.paths[p], tooling))
      ofPatch[plan.paths[p].patch].push_back(p);
  if (ofPatch.empty())
    return;
  const LevelPatches levels(stack, ctx);
  const std::vector<std::pair<int, std::vector<std::size_t>>> patches(ofPatch.begin(),
                                                                      ofPatch.end());
  base::parallelChunks(ctx, patches.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const PlanePatch* plane = levels.patch(at(patches[k].first));
      const ClipperLib::Paths below = plane ? levels.below(*plane) : ClipperLib::Paths{};
      if (below.empty())
        continue;
      std::map<long, OverhangZones> zonesOf; // by the width of the bead
      for (const std::size_t p : patches[k].second) {
        const plan::ToolPath& path = plan.paths[p];
        const process::OverhangSpeed& speed = tooling.of(path).process.overhangSpeed;
        const double usual = usualSpeed(path, tooling.of(path).process);
        OverhangZones& zones =
            zonesOf
                .try_emplace(std::lround(plan.widthMm[path.first] / kWidthStepMm), below,
                             plan.widthMm[path.first])
                .first->second;
        double before = 0.0;
        for (std::size_t i = path.first; i < path.first + path.count; ++i) {
          const double here = zones.overhangAt((plane->plane_R_work * plan.position[i]).head<2>());
          // The speed is that of the way to the waypoint.
          const double overhang = i == path.first ? here : std::max(here, before);
          if (overhang > 0.0)
            plan.speedMmPerS[i] =
                std::min(plan.speedMmPerS[i], static_cast<float>(speed.at(overhang) * usual));
          before = here;
        }
      }
    }
  });
}

} // namespace voluta::toolpath
