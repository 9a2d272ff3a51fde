#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "pipeline/stages.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/tooling.h"
#include "robot/cell.h"
#include "toolpath/plan_toolpaths.h"

namespace voluta::pipeline {

MadeToolpaths toolpathStage(std::vector<toolpath::ItemLayers> items,
                            const layers::LayerStack& joined, const robot::Cell& cell,
                            const platform::PlatformSolid& platform,
                            const process::Tooling& tooling, const base::RunContext& ctx,
                            std::span<const Eigen::Vector3d> others) {
  auto stage = std::make_shared<ToolpathStage>();
  for (toolpath::ItemLayers& item : items)
    for (toolpath::CoverRules& rules : item.rules)
      rules.options.platform = platform;
  toolpath::ToolpathResult planned =
      toolpath::planToolpaths(items, joined, cell, tooling, ctx, others);
  stage->report = planned.statistics;
  stage->timings.toolpath = planned.seconds.toolpath;
  stage->timings.orient = planned.seconds.orient;
  stage->findings = std::move(planned.findings);
  stage->toolPlan = std::make_shared<plan::ToolPlan>(std::move(planned.plan));
  return {std::move(stage), std::move(planned.grown)};
}

} // namespace voluta::pipeline
