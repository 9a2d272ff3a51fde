#include "pipeline/placed_programs.h"

#include "motion/resumed_motion.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"

namespace voluta::pipeline {

namespace {
std::vector<Eigen::Vector3d> printedEarlier(const project::Job& job) {
  std::vector<Eigen::Vector3d> points;
  if (job.resumedAt == 0)
    return points;
  const plan::ToolPlan& plan = *job.toolPlan;
  const std::size_t printed = motion::printedBefore(*job.trajectory, job.resumedAt);
  for (std::size_t i = 0; i < printed; ++i)
    points.push_back(plan.position[i] -
                     0.5 * static_cast<double>(plan.heightMm[i]) * plan.direction[i]);
  return points;
}
} // namespace

std::vector<replay::PlacedProgram>
placedPrograms(const std::vector<plan::ReadProgram>& programs, const std::vector<PlanResult>& plans,
               const std::vector<Eigen::Isometry3d>& shared_T_world) {
  std::vector<replay::PlacedProgram> placed;
  for (std::size_t k = 0; k < programs.size(); ++k)
    placed.push_back({programs[k], *plans[k].cell, plans[k].tooling().first().process,
                      shared_T_world[k], printedEarlier(plans[k].job)});
  return placed;
}

} // namespace voluta::pipeline
