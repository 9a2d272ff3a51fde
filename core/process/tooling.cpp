#include "process/tooling.h"

#include <algorithm>

#include "base/error.h"

#include <utility>

namespace voluta::process {

Tooling::Tooling(Process process) : Tooling(std::vector<Tool>{{std::move(process)}}) {}

Tooling::Tooling(std::vector<Tool> tools)
    : tools_(std::make_shared<const std::vector<Tool>>(std::move(tools))) {
  base::require(!tools_->empty(), "a job has a tool");
}

const Tool& Tooling::at(int tool) const {
  base::require(tool >= 0 && static_cast<std::size_t>(tool) < tools_->size(), "a tool of the job");
  return (*tools_)[static_cast<std::size_t>(tool)];
}

std::span<const Tool> Tooling::usedAfter(const plan::Trajectory& trajectory,
                                         std::size_t point) const {
  return tools().first(trajectory.changesTool(point) ? tools_->size() : 1);
}

double Tooling::fullFlowMm3PerS() const {
  double full = 0.0;
  for (const Tool& tool : *tools_)
    full = std::max(full, tool.process.maxFlowMm3PerS);
  return full;
}

} // namespace voluta::process
