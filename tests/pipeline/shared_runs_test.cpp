// Programs of one plan that say its joint motions in different pieces are replayed once.
#include "box_request.h"
#include "pipeline/replayed/shared_runs.h"
#include "pipeline/stages.h"

#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;

// A joint motion said in `pieces`, on one line in joint space.
plan::Trajectory withPieces(const plan::Trajectory& whole, std::size_t pieces) {
  plan::Trajectory t;
  t.dof = whole.dof;
  const auto push = [&](std::size_t i, double share) {
    for (int j = 0; j < whole.dof; ++j)
      t.joints.push_back(
          whole.at(i)[j] -
          (share < 1.0 ? (1.0 - share) * (whole.at(i)[j] - whole.at(i - 1)[j]) : 0.0));
    t.timeS.push_back(whole.timeS[i] -
                      (i > 0 ? (1.0 - share) * (whole.timeS[i] - whole.timeS[i - 1]) : 0.0));
    t.extrudedMm3.push_back(whole.extrudedMm3[i]);
    t.move.push_back(whole.move[i]);
    t.waypoint.push_back(share < 1.0 ? plan::kNoWaypoint : whole.waypoint[i]);
  };
  for (std::size_t i = 0; i < whole.pointCount(); ++i) {
    const bool split =
        i > 0 && whole.move[i] == plan::MoveKind::Joint && whole.timeS[i] > whole.timeS[i - 1];
    for (std::size_t k = 1; split && k < pieces; ++k)
      push(i, static_cast<double>(k) / static_cast<double>(pieces));
    push(i, 1.0);
  }
  return t;
}

TEST(SharedRuns, BeadsAreLaidOnceThoughTransfersAreSaidInOtherPieces) {
  const PlanResult& plan = test::boxPlan();
  const plan::Trajectory pieces = withPieces(*plan.job.trajectory, 3);
  ASSERT_GT(pieces.pointCount(), plan.job.trajectory->pointCount());
  const auto part = plan.job.item().printed();
  const ProgramStageInput in{
      part, plan.job.item().platform, *plan.job.toolPlan, pieces, *plan.cell, *plan.tooling, "box"};
  SharedRuns shared;
  const auto native = programStage("urscript", in, kCtx, &shared);
  const auto foreign = programStage("gcode-extended", in, kCtx, &shared);
  ASSERT_EQ(shared.runs().size(), 2u);
  EXPECT_NE(shared.runs()[0].run.path.motionCount(), shared.runs()[1].run.path.motionCount())
      << "urscript says a transfer's pieces as one";
  EXPECT_EQ(shared.runs()[0].laid, shared.runs()[1].laid);
  EXPECT_EQ(native->verdict.collisions, foreign->verdict.collisions);
  EXPECT_DOUBLE_EQ(native->verdict.coveredFraction, foreign->verdict.coveredFraction);
}

} // namespace
