#include "pipeline/early_verdict.h"
#include "replay/verification.h"

#include "pipeline/box_request.h"
#include "plan/finding_kinds.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

class EarlyVerdict : public testing::Test {
protected:
  std::optional<plan::Finding> verdictOn(const plan::ToolPlan& toolPlan) const {
    return pipeline::massOutOfReach(toolPlan, box_.job.item().printed(),
                                    box_.tooling().first().process,
                                    replay::ReplayThresholds().massTolerance);
  }

  const pipeline::PlanResult& box_ = test::boxPlan();
  const plan::ToolPlan& planned_ = *box_.job.toolPlan;
};

TEST_F(EarlyVerdict, AWayThatPassesIsNeverEnded) {
  ASSERT_TRUE(box_.job.report.replay.passed);
  EXPECT_FALSE(verdictOn(planned_));
  // As far off as a controller may take it.
  for (const float share : {0.95f, 1.05f}) {
    plan::ToolPlan other = planned_;
    for (float& width : other.widthMm)
      width *= share;
    EXPECT_FALSE(verdictOn(other)) << share;
  }
}

TEST_F(EarlyVerdict, MaterialThatNoReplayPassesIsFoundInTheToolPaths) {
  plan::ToolPlan wide = planned_;
  for (float& width : wide.widthMm)
    width *= 1.5f;
  plan::ToolPlan half = planned_;
  half.paths.resize(half.paths.size() / 2);
  for (const plan::ToolPlan& wrong : {wide, half}) {
    const auto verdict = verdictOn(wrong);
    ASSERT_TRUE(verdict);
    EXPECT_EQ(verdict->kind, plan::FindingKind::Mass);
    EXPECT_TRUE(verdict->blocking);
  }
}

} // namespace
