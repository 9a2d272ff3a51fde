#include "record/planned_run.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/polyline.h"

#include <algorithm>
#include <cmath>

namespace voluta::record {

namespace {
using Eigen::Vector3d;

robot::JointVector jointsAt(const plan::Trajectory& trajectory, std::size_t point) {
  return Eigen::Map<const Eigen::VectorXd>(trajectory.at(point), trajectory.dof);
}

std::vector<Vector3d> tipsOf(const plan::Trajectory& trajectory, const robot::Cell& cell,
                             const base::RunContext& ctx) {
  constexpr std::size_t kGrain = 2048;
  std::vector<Vector3d> tips(trajectory.pointCount());
  base::parallelChunks(ctx, tips.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      tips[i] = cell.work_T_tool(jointsAt(trajectory, i)).translation();
  });
  return tips;
}

void append(PlannedRun& run, const Vector3d& tip, double timeS, double mm3, bool prints,
            std::size_t point) {
  run.alongMm.push_back(run.tip.empty() ? 0.0 : run.alongMm.back() + (tip - run.tip.back()).norm());
  run.tip.push_back(tip);
  run.timeS.push_back(timeS);
  run.extrudedMm3.push_back(mm3);
  run.prints.push_back(prints ? 1 : 0);
  run.point.push_back(point);
}

// Appends the inner vertices of a joint motion.
void appendArc(PlannedRun& run, const plan::Trajectory& trajectory, const robot::Cell& cell,
               std::size_t point) {
  constexpr double kMaxMm = 2.0, kMaxRad = 0.02;
  constexpr int kMaxPieces = 2000;
  const robot::JointVector from = jointsAt(trajectory, point - 1), to = jointsAt(trajectory, point);
  const double straight = (cell.work_T_tool(to).translation() - run.tip.back()).norm();
  const double angle = (to - from).cwiseAbs().maxCoeff();
  const int pieces = std::clamp(
      static_cast<int>(std::ceil(std::max(straight / kMaxMm, angle / kMaxRad))), 1, kMaxPieces);
  const double fromS = trajectory.timeS[point - 1], toS = trajectory.timeS[point];
  for (int k = 1; k < pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    append(run, cell.work_T_tool(from + share * (to - from)).translation(),
           fromS + share * (toS - fromS), trajectory.extrudedMm3[point - 1], false, point);
  }
}
} // namespace

PlannedPlace placeAt(const PlannedRun& run, double alongMm) {
  base::require(run.size() > 1, "placeAt: two vertices");
  const auto [a, share] = geometry::placeAtLength(run.alongMm, alongMm, run.size() - 2);
  PlannedPlace place;
  const std::size_t b = place.segment = a + 1;
  place.alongMm = run.alongMm[a] + share * (run.alongMm[b] - run.alongMm[a]);
  place.timeS = run.timeS[a] + share * (run.timeS[b] - run.timeS[a]);
  place.extrudedMm3 = run.extrudedMm3[a] + share * (run.extrudedMm3[b] - run.extrudedMm3[a]);
  return place;
}

PlannedRun plannedRun(const plan::Trajectory& trajectory, const robot::Cell& cell,
                      std::size_t first, const base::RunContext& ctx) {
  base::require(trajectory.dof == cell.dof() && first < trajectory.pointCount(),
                "plannedRun: the trajectory is the cell's and has points");
  const std::vector<Vector3d> tips = tipsOf(trajectory, cell, ctx);
  PlannedRun run;
  for (std::size_t i = first; i < tips.size(); ++i) {
    if (i % 4096 == 0)
      ctx.checkpoint();
    const plan::MoveKind move = trajectory.move[i];
    if (i > first && move == plan::MoveKind::Joint)
      appendArc(run, trajectory, cell, i);
    append(run, tips[i], trajectory.timeS[i], trajectory.extrudedMm3[i],
           i > first && move == plan::MoveKind::Print, i);
  }
  return run;
}

} // namespace voluta::record
