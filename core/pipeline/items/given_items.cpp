#include "pipeline/items/given_items.h"

#include "pipeline/items/joined_plans.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "toolpath/path_figures.h"

#include <algorithm>

namespace voluta::pipeline {

std::vector<Eigen::Vector3d> placesOf(const GivenItems& given) {
  std::vector<Eigen::Vector3d> places;
  for (const GivenItem& one : given)
    places.insert(places.end(), one.stage->toolPlan->position.begin(),
                  one.stage->toolPlan->position.end());
  return places;
}

std::shared_ptr<const ToolpathStage> joinedStage(const ToolpathStage& planned,
                                                 const GivenItems& given, layers::PrintOrder order,
                                                 std::span<const std::size_t> sequence,
                                                 const process::Tooling& tooling) {
  auto stage = std::make_shared<ToolpathStage>(planned);
  std::vector<GivenPlan> plans;
  for (const GivenItem& one : given) {
    plans.push_back({one.item, one.stage->toolPlan});
    stage->report.maxRotationDeg =
        std::max(stage->report.maxRotationDeg, one.stage->report.maxRotationDeg);
    stage->timings += one.stage->timings;
    for (plan::Finding finding : one.stage->findings) {
      finding.item = static_cast<int>(one.item);
      stage->findings.push_back(std::move(finding));
    }
  }
  stage->toolPlan = std::make_shared<plan::ToolPlan>(
      joinedPlans(planned.toolPlan ? *planned.toolPlan : plan::ToolPlan(), plans, order, sequence));
  toolpath::setPathFigures(*stage->toolPlan, sequence.size(), tooling, stage->report);
  return stage;
}

} // namespace voluta::pipeline
