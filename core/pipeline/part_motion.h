// The Motion stage: from tool-paths to the robot's motion on the platform, once, and again without
// places where a replay found that something meets.
#pragma once

#include "base/run_context.h"
#include "motion/motion_options.h"
#include "pipeline/stages.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "robot/cell.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace voluta::collision {
class GrowingPart;
}
namespace voluta::motion {
class MotionPlanner;
struct MotionResult;
} // namespace voluta::motion

namespace voluta::pipeline {

class PartMotion {
public:
  // Lays the part that grows. toolPlan, cell and process must outlive the object. Throws Cancelled.
  PartMotion(const plan::ToolPlan& toolPlan, const platform::PlatformSolid& platform,
             const robot::Cell& cell, const process::Process& process,
             const motion::MotionOptions& options, const base::RunContext& ctx);
  ~PartMotion();

  // Once. Throws Cancelled.
  std::shared_ptr<const MotionStage> plan(const base::RunContext& ctx);
  // After plan: without these waypoints and those of earlier calls; only their paths are planned
  // again. Throws Cancelled.
  std::shared_ptr<const MotionStage> planWithout(const std::vector<std::size_t>& waypoints,
                                                 const base::RunContext& ctx);

private:
  std::shared_ptr<const MotionStage> stageOf(motion::MotionResult moved);

  const robot::Cell& cell_;
  std::unique_ptr<const collision::GrowingPart> growing_; // null: nothing to print
  std::unique_ptr<motion::MotionPlanner> planner_;        // null: nothing to print
  double depositS_ = 0.0;                                 // not told of yet
};

} // namespace voluta::pipeline
