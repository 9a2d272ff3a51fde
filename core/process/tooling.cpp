#include "process/tooling.h"

#include "base/error.h"

#include <utility>

namespace voluta::process {

namespace {
Tool toolOf(Process process) {
  Tool tool;
  tool.process = std::move(process);
  return tool;
}
} // namespace

Tooling::Tooling(Process process) : Tooling(std::vector<Tool>{toolOf(std::move(process))}) {}

Tooling::Tooling(std::vector<Tool> tools)
    : tools_(std::make_shared<const std::vector<Tool>>(std::move(tools))) {
  if (tools_->empty())
    throw base::Error(base::ErrorCode::Internal, base::message("a job without a tool"_text));
}

const Tool& Tooling::at(int tool) const {
  if (tool < 0 || static_cast<std::size_t>(tool) >= tools_->size())
    throw base::Error(base::ErrorCode::Internal,
                      base::message("the plan names tool {tool}, the job has {tools}"_text,
                                    base::number(tool), base::number(tools_->size())));
  return (*tools_)[static_cast<std::size_t>(tool)];
}

} // namespace voluta::process
