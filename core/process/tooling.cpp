#include "process/tooling.h"

#include "base/error.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/bead_to.h"

#include <algorithm>
#include <utility>

namespace voluta::process {

Tooling::Tooling(Process process) : Tooling(std::vector<Tool>{{std::move(process)}}) {}

Tooling::Tooling(std::vector<Tool> tools)
    : tools_(std::make_shared<const std::vector<Tool>>(std::move(tools))) {
  base::require(!tools_->empty(), "a job has a tool");
}

const Tool& Tooling::of(const plan::ToolPath& path) const {
  return at(path.tool);
}

const Tool& Tooling::at(int tool) const {
  base::require(tool >= 0 && static_cast<std::size_t>(tool) < tools_->size(), "a tool of the job");
  return (*tools_)[static_cast<std::size_t>(tool)];
}

std::vector<int> Tooling::usedAfter(const plan::Trajectory& trajectory, std::size_t point) const {
  std::vector<int> used = {trajectory.toolAt(point)};
  for (const plan::TrajectoryEvent& event : trajectory.events)
    if (event.kind == plan::EventKind::ToolChange && event.point > point)
      used.push_back(event.tool);
  std::ranges::sort(used);
  used.erase(std::ranges::unique(used).begin(), used.end());
  return used;
}

std::vector<ToolUse> Tooling::usesOf(const plan::Trajectory& trajectory) const {
  std::vector<ToolUse> uses(tools_->size());
  auto tool = static_cast<std::size_t>(trajectory.firstTool);
  base::require(tool < uses.size(), "a motion that begins with a tool of the job");
  double before = 0.0;
  const auto printTo = [&](double mm3) {
    uses[tool].printedMm3 += mm3 - std::exchange(before, mm3);
  };
  for (const plan::TrajectoryEvent& event : trajectory.events) {
    if (event.kind == plan::EventKind::ToolChange) {
      printTo(trajectory.extrudedMm3[event.point - 1]);
      base::require(event.tool >= 0 && static_cast<std::size_t>(event.tool) < uses.size(),
                    "a change to a tool of the job");
      tool = static_cast<std::size_t>(event.tool);
    }
    (event.kind == plan::EventKind::Shot ? uses[tool].printedMm3 : uses[tool].purgedMm3) +=
        event.volumeMm3;
  }
  if (!trajectory.extrudedMm3.empty())
    printTo(trajectory.extrudedMm3.back());
  return uses;
}

double Tooling::printedG(const plan::Trajectory& trajectory) const {
  const std::vector<ToolUse> uses = usesOf(trajectory);
  double g = 0.0;
  for (std::size_t tool = 0; tool < uses.size(); ++tool)
    g += 1e-3 * uses[tool].printedMm3 * (*tools_)[tool].process.material.densityGPerCm3;
  return g;
}

double Tooling::printedG(const plan::ToolPlan& plan) const {
  const auto volumeTo = [&](const plan::ToolPath& path, std::size_t i) {
    if (path.kind != plan::PathKind::Tape)
      return beadTo(plan, i);
    return static_cast<double>(plan.widthMm[i]) * static_cast<double>(plan.heightMm[i]) *
           (plan.position[i] - plan.position[i - 1]).norm();
  };
  double g = 0.0;
  for (const plan::ToolPath& path : plan.paths) {
    const bool isShot = path.kind == plan::PathKind::Shot;
    double mm3 = isShot ? plan.shotMm3(path) : 0.0;
    for (std::size_t i = path.first + 1; !isShot && i < path.first + path.count; ++i)
      mm3 += volumeTo(path, i);
    g += 1e-3 * mm3 * of(path).process.material.densityGPerCm3;
  }
  return g;
}

double Tooling::fullFlowMm3PerS() const {
  double full = 0.0;
  for (const Tool& tool : *tools_)
    full = std::max(full, tool.process.maxFlowMm3PerS);
  return full;
}

} // namespace voluta::process
