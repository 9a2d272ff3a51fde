// The Motion stage: from tool-paths to the robot's motion on the platform, once, and again without
// places where a replay found that something meets.
#pragma once

#include "base/run_context.h"
#include "collision/growing_part.h"
#include "motion/motion_options.h"
#include "pipeline/stages.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "robot/cell.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::motion {
class MotionPlanner;
struct MotionResult;
} // namespace voluta::motion

namespace voluta::pipeline {

class PartMotion {
public:
  // Lays the part that grows, or takes what toolpathStage() has `grown` on the platform.
  // toolPlan, cell and process must outlive the object. Throws Cancelled.
  PartMotion(const plan::ToolPlan& toolPlan, const platform::PlatformSolid& platform,
             const robot::Cell& cell, const process::Process& process,
             const motion::MotionOptions& options,
             std::shared_ptr<const collision::GrowingPart> grown, const base::RunContext& ctx);
  ~PartMotion();

  // Once. Gives up where more than `mostLeftOut` of the material cannot be printed: the stage has
  // findings and no trajectory then. Throws Cancelled.
  std::shared_ptr<const MotionStage> plan(const base::RunContext& ctx, double mostLeftOut = 1.0);
  // After plan: without these waypoints and those of earlier calls; only their paths are planned
  // again. Throws Cancelled.
  std::shared_ptr<const MotionStage> planWithout(const std::vector<std::size_t>& waypoints,
                                                 const base::RunContext& ctx);

private:
  void layPart(const base::RunContext& ctx);
  std::shared_ptr<const MotionStage> stageOf(motion::MotionResult moved);

  const plan::ToolPlan& toolPlan_;
  const robot::Cell& cell_;
  platform::PlatformSolid ground_;
  double pitchMm_; // of the growing part's cells
  // Only while something is planned: it is large, and laid in a fraction of a second. The planner
  // refers to it where it stands.
  std::optional<collision::GrowingPart> growing_;
  std::unique_ptr<motion::MotionPlanner> planner_; // null: nothing to print
  double depositS_ = 0.0;                          // not told of yet
};

} // namespace voluta::pipeline
