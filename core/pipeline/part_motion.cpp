#include "pipeline/part_motion.h"

#include "base/run_context.h"
#include "base/stopwatch.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "pipeline/item_events.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include <utility>

namespace voluta::pipeline {

PartMotion::PartMotion(const plan::ToolPlan& toolPlan, const platform::PlatformSolid& platform,
                       const robot::Cell& cell, const process::Tooling& tooling,
                       const motion::MotionOptions& options,
                       std::shared_ptr<const collision::GrowingPart> grown,
                       const base::RunContext& ctx)
    : toolPlan_(toolPlan), cell_(cell), ground_(platform),
      pitchMm_(collision::growingPitch(toolPlan, tooling)) {
  ground_.rod.reset(); // a rod is a body of the cell
  if (toolPlan.paths.empty())
    return;
  requireEventPlaces(toolPlan, options.layerEvents);
  // In the motion stage a rod is a body of the cell; in `grown` it is ground cells.
  if (grown && !platform.rod)
    growing_ = *grown;
  else
    layPart(ctx);
  planner_ = std::make_unique<motion::MotionPlanner>(toolPlan, cell, tooling, *growing_, options);
}

void PartMotion::layPart(const base::RunContext& ctx) {
  const base::Stopwatch depositing;
  growing_.emplace(toolPlan_, pitchMm_, ctx,
                   collision::groundCells(ground_, toolPlan_, pitchMm_, ctx));
  depositS_ += depositing.seconds();
}

PartMotion::~PartMotion() = default;

std::shared_ptr<const MotionStage> PartMotion::plan(const base::RunContext& ctx,
                                                    double maxLeftOut) {
  if (planner_)
    return stageOf(planner_->plan(ctx, maxLeftOut));
  auto stage = std::make_shared<MotionStage>();
  stage->report = {{}, cell_.robot().id, cell_.id()};
  stage->findings = {plan::makeFinding(plan::FindingKind::NothingToPrint)};
  return stage;
}

std::shared_ptr<const MotionStage>
PartMotion::planWithout(const std::vector<std::size_t>& waypoints, const base::RunContext& ctx) {
  if (!planner_)
    return plan(ctx);
  layPart(ctx);
  return stageOf(planner_->planWithout(waypoints, ctx));
}

std::shared_ptr<const MotionStage> PartMotion::stageOf(motion::MotionResult moved) {
  growing_.reset();
  auto stage = std::make_shared<MotionStage>();
  stage->report = {std::move(moved.statistics), cell_.robot().id, cell_.id()};
  stage->timings.ik = moved.times.ik;
  stage->timings.graph = moved.times.graph;
  stage->timings.collision = std::exchange(depositS_, 0.0) + moved.times.collision;
  stage->timings.jerk = moved.times.jerk;
  stage->timings.transfer = moved.times.transfer;
  stage->tooLarge = moved.tooLarge;
  stage->findings = std::move(moved.findings);
  if (!moved.isGivenUp)
    stage->trajectory = std::make_shared<plan::Trajectory>(std::move(moved.trajectory));
  return stage;
}

} // namespace voluta::pipeline
