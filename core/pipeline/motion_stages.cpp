// From layers to tool-paths, from tool-paths to the robot's motion.
#include "base/stopwatch.h"
#include "collision/growing_part.h"
#include "motion/motion.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "toolpath/plan_toolpaths.h"

namespace voluta::pipeline {

std::shared_ptr<const ToolpathStage> toolpathStage(const layers::LayerStack& layers,
                                                   const platform::PlatformSolid& platform,
                                                   const process::Process& process,
                                                   toolpath::ToolpathOptions options,
                                                   const base::RunContext& ctx) {
  auto stage = std::make_shared<ToolpathStage>();
  options.platform = platform;
  toolpath::ToolpathResult planned = toolpath::planToolpaths(layers, process, options, ctx);
  const toolpath::ToolpathStatistics& s = planned.statistics;
  project::ToolpathReport& r = stage->report;
  r.paths = s.paths;
  r.waypoints = s.waypoints;
  r.lengthMm = s.lengthMm;
  r.travelMm = s.travelMm;
  r.starts = s.starts;
  r.simpleRegions = s.simpleRegions;
  r.coveredFraction = s.coveredFraction;
  r.overlapFraction = s.overlapFraction;
  r.gouges = s.gouges;
  r.maxTurnDeg = s.maxTurnDeg;
  r.materialMm3 = s.materialMm3;
  stage->timings.toolpath = planned.seconds.toolpath;
  stage->timings.orient = planned.seconds.orient;
  stage->findings = std::move(planned.findings);
  stage->toolPlan = std::make_shared<plan::ToolPlan>(std::move(planned.plan));
  return stage;
}

std::shared_ptr<const MotionStage>
motionStage(const plan::ToolPlan& toolPlan, const platform::PlatformSolid& platform,
            const robot::Cell& cell, const process::Process& process,
            const motion::MotionOptions& options, const base::RunContext& ctx,
            const std::vector<std::size_t>& avoided) {
  auto stage = std::make_shared<MotionStage>();
  project::MotionReport& r = stage->report;
  r.robot = cell.robot().id;
  r.cell = cell.id();
  if (toolPlan.paths.empty()) {
    stage->findings = {plan::makeFinding(plan::FindingKind::NothingToPrint)};
    return stage;
  }
  base::Stopwatch depositing;
  platform::PlatformSolid ground = platform;
  ground.rod.reset(); // it is a body of the cell
  const double pitch = collision::growingPitch(toolPlan, process);
  const collision::GrowingPart growing(toolPlan, pitch, ctx.sub(0.0, 0.05),
                                       collision::groundCells(ground, pitch, ctx));
  const double deposited = depositing.seconds();
  motion::MotionResult planned =
      motion::planMotion(toolPlan, cell, process, growing, options, ctx.sub(0.05, 1.0), avoided);
  const motion::MotionStatistics& s = planned.statistics;
  r.waypoints = s.waypoints;
  r.unreachable = s.unreachable;
  r.collisions = s.collisions;
  r.splits = s.splits;
  r.maxJerk = s.maxJerk;
  r.sumSquaredJerk = s.sumSquaredJerk;
  r.sumSquaredJerkBefore = s.sumSquaredJerkBefore;
  r.minClearanceMm = s.minClearanceMm;
  r.durationS = s.durationS;
  stage->timings.ik = planned.times.ik;
  stage->timings.graph = planned.times.graph;
  stage->timings.collision = deposited + planned.times.collision;
  stage->timings.jerk = planned.times.jerk;
  stage->timings.transfer = planned.times.transfer;
  stage->findings = std::move(planned.findings);
  stage->trajectory = std::make_shared<plan::Trajectory>(std::move(planned.trajectory));
  return stage;
}

} // namespace voluta::pipeline
