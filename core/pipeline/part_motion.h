// The Motion stage: plans the robot's motion along the tool-paths on the platform, and plans again
// without the waypoints at which a replay found collisions.
#pragma once

#include "collision/growing_part.h"
#include "platform/platform_solid.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::motion {
struct MotionOptions;
class MotionPlanner;
struct MotionResult;
} // namespace voluta::motion
namespace voluta::plan {
struct ToolPlan;
}
namespace voluta::process {
class Tooling;
}
namespace voluta::robot {
class Cell;
}

namespace voluta::pipeline {

struct MotionStage;

class PartMotion {
public:
  // Deposits the growing part, or uses `grown` from toolpathStage(), on the platform. toolPlan
  // and cell must outlive the object. Throws Cancelled; Error{Usage} if a part lacks a layer of
  // options.layerEvents.
  PartMotion(const plan::ToolPlan& toolPlan, const platform::PlatformSolid& platform,
             const robot::Cell& cell, const process::Tooling& tooling,
             const motion::MotionOptions& options,
             std::shared_ptr<const collision::GrowingPart> grown, const base::RunContext& ctx);
  ~PartMotion();

  // Call once. Gives up if more than the fraction `maxLeftOut` of the material cannot be printed;
  // the stage then has findings but no trajectory. Throws Cancelled.
  std::shared_ptr<const MotionStage> plan(const base::RunContext& ctx, double maxLeftOut = 1.0);
  // Call after plan(). Plans again without these waypoints and those of earlier calls; replans only
  // the affected paths. Throws Cancelled.
  std::shared_ptr<const MotionStage> planWithout(const std::vector<std::size_t>& waypoints,
                                                 const base::RunContext& ctx);

private:
  void layPart(const base::RunContext& ctx);
  std::shared_ptr<const MotionStage> stageOf(motion::MotionResult moved);

  const plan::ToolPlan& toolPlan_;
  const robot::Cell& cell_;
  platform::PlatformSolid ground_;
  double pitchMm_; // cell size of the growing part
  // Exists only during planning: it is large, and is rebuilt in a fraction of a second. The planner
  // keeps a reference to it.
  std::optional<collision::GrowingPart> growing_;
  std::unique_ptr<motion::MotionPlanner> planner_; // null if there is nothing to print
  double depositS_ = 0.0;                          // deposit time not reported yet
};

} // namespace voluta::pipeline
