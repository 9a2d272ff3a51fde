// Pauses before layers, as they are asked for and as they come.
#include "base/error.h"
#include "pipeline/box_request.h"
#include "pipeline/plan_result.h"
#include "pipeline/plan_verdict.h"
#include "plan/trajectory.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

PlanResult pausing(const std::string& layers) {
  PlanRequest request = test::boxRequest({{"pauseLayers", layers}});
  request.choices.item().mode = "flat";
  request.choices.formats = {"urscript"};
  return planPart(request, base::RunContext());
}

std::size_t pausesOf(const PlanResult& plan) {
  return static_cast<std::size_t>(std::ranges::count(
      plan.job.trajectory->events, plan::EventKind::Pause, &plan::TrajectoryEvent::kind));
}

TEST(PauseLayers, ComeBeforeTheLayersThatThePrintHas) {
  const PlanResult plan = pausing("3, 5");
  EXPECT_EQ(pausesOf(plan), 2u);
  EXPECT_EQ(verdictOf(plan.job.report), PlanVerdict::Passed);
}

TEST(PauseLayers, ALayerThatThePrintLacksIsRefused) {
  try {
    pausing("3, 99");
    FAIL() << "a pause that never comes";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ErrorCode::Usage);
    EXPECT_NE(base::english(error.whole()).find("before layer 99"), std::string::npos);
  }
}

} // namespace
