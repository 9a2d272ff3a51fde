#include "pipeline/stages.h"
#include "toolpath/plan_toolpaths.h"

namespace voluta::pipeline {

MadeToolpaths toolpathStage(const layers::LayerStack& layers, const robot::Cell& cell,
                            const platform::PlatformSolid& platform,
                            const process::Tooling& tooling, toolpath::ToolpathOptions options,
                            const base::RunContext& ctx) {
  auto stage = std::make_shared<ToolpathStage>();
  options.platform = platform;
  toolpath::ToolpathResult planned = toolpath::planToolpaths(layers, cell, tooling, options, ctx);
  stage->report = planned.statistics;
  stage->timings.toolpath = planned.seconds.toolpath;
  stage->timings.orient = planned.seconds.orient;
  stage->findings = std::move(planned.findings);
  stage->toolPlan = std::make_shared<plan::ToolPlan>(std::move(planned.plan));
  return {std::move(stage), std::move(planned.grown)};
}

} // namespace voluta::pipeline
