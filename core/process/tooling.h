// The tools of a job: each deposits one material with one process (shared by all stages that see a
// whole plan; functions that see one patch or one motion take the Process).
#pragma once

#include "process/process.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace voluta::plan {
struct ToolPath;
struct ToolPlan;
struct Trajectory;
} // namespace voluta::plan

namespace voluta::process {

struct Tool {
  Process process; // with material and head body
};

// Material that a tool deposits [mm3].
struct ToolUse {
  double printedMm3 = 0.0, purgedMm3 = 0.0; // purged: after tool changes
};

// One or more tools; a copy shares them.
class Tooling {
public:
  // One tool with that process. Explicit, so that no stage drops a job's further tools unnoticed.
  explicit Tooling(Process process);
  // Throws Error{Internal} if there is none.
  explicit Tooling(std::vector<Tool> tools);

  std::span<const Tool> tools() const { return *tools_; }
  // The tool of a path. Throws Error{Internal} if the plan names a tool that the job does not have.
  const Tool& of(const plan::ToolPath& path) const;
  const Tool& at(int tool) const;
  // The job's first tool, which a motion need not begin with (plan::Trajectory::firstTool).
  const Tool& first() const { return tools_->front(); }
  bool isOne() const { return tools_->size() == 1; }
  // The use of each tool.
  std::vector<ToolUse> usesOf(const plan::Trajectory& trajectory) const;
  // The mass of all that is printed, without purges [g].
  double printedG(const plan::Trajectory& trajectory) const;
  // The same of planned paths.
  double printedG(const plan::ToolPlan& plan) const;
  // The flow that outputs state as full [mm3/s]: that of the tool with the largest one.
  double fullFlowMm3PerS() const;
  // The tools that a program needs that begins at a point of the trajectory, ascending: the one
  // selected there and those that are selected later.
  std::vector<int> usedAfter(const plan::Trajectory& trajectory, std::size_t point) const;

private:
  std::shared_ptr<const std::vector<Tool>> tools_;
};

} // namespace voluta::process
