#include "toolpath/unsupported/slow_bridges.h"

#include "base/error.h"
#include "base/run_context.h"

#include <algorithm>

namespace voluta::toolpath {

std::optional<PassResult> slowBridges(const UnsupportedBeads& beads, const SeenPart& /*part*/,
                                      const PassScene& scene, const base::RunContext& ctx) {
  const std::vector<char>& unsupported = beads.unsupported;
  base::require(unsupported.size() == beads.plan.waypointCount(), "a mark for each waypoint");
  ctx.checkpoint();
  if (std::ranges::find(unsupported, 1) == unsupported.end())
    return std::nullopt;
  PassResult out{beads};
  plan::ToolPlan& plan = out.beads.plan;
  for (const plan::ToolPath& path : plan.paths) {
    const auto limit = static_cast<float>(scene.tooling.of(path).process.bridgeSpeedMmPerS);
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      if (unsupported[i] || (i > path.first && unsupported[i - 1]))
        plan.speedMmPerS[i] = std::min(plan.speedMmPerS[i], limit);
  }
  return out;
}

} // namespace voluta::toolpath
