#include "project/named_tools.h"

#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"

#include <algorithm>

namespace voluta::project {

bool namesKnownOnes(const Job& job) {
  const std::size_t tools = job.choices.tools.size(), items = job.items.size();
  const auto isTool = [&](int tool) { return tool >= 0 && static_cast<std::size_t>(tool) < tools; };
  for (const JobItem& item : job.items)
    if (item.layers && (!std::ranges::all_of(item.layers->patches, isTool, &layers::Patch::tool) ||
                        !std::ranges::all_of(item.layers->pockets, isTool, &layers::Pocket::tool)))
      return false;
  if (job.toolPlan && !std::ranges::all_of(job.toolPlan->paths, [&](const plan::ToolPath& path) {
        return isTool(path.tool) && static_cast<std::size_t>(path.item) < items;
      }))
    return false;
  return !job.trajectory ||
         (isTool(job.trajectory->firstTool) &&
          std::ranges::all_of(job.trajectory->events, [&](const plan::TrajectoryEvent& event) {
            return event.kind == plan::EventKind::Mark || event.kind == plan::EventKind::Output ||
                   isTool(event.tool);
          }));
}

} // namespace voluta::project
