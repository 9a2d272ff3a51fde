// Parts with tapes of continuous fibre from the mesh to the replayed program (Dai 5.4).
#include "pipeline/road.h"

#include "base/error.h"
#include "base/run_context.h"
#include "plan/finding_kinds.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using Values = std::map<std::string, std::string>;

PlanRequest fibreRequest(const char* sample, const char* mode, const Values& values) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  PlanRequest request;
  request.item().part = sample;
  request.choices.tools = {{"fdm-1.0"}, {"tape-5"}};
  request.choices.cell = "irb2400-moving";
  request.choices.formats = {"gcode-extended"};
  request.choices.item().mode = mode;
  request.choices.item().parameters = values;
  request.choices.item().parameters["fibreLayers"] = "1";
  request.choices.item().parameters["output.proof"] = "false";
  return request;
}

std::string reasons(const PlanResult& plan) {
  std::string all;
  for (const plan::Finding& finding : plan.job.report.findings)
    all += plan::englishReason(finding) + "\n";
  return all;
}

std::size_t eventsOf(const plan::Trajectory& trajectory, plan::EventKind kind) {
  return static_cast<std::size_t>(
      std::ranges::count(trajectory.events, kind, &plan::TrajectoryEvent::kind));
}

// What holds for every example: tapes of that length, each cut, as many grams as planned.
void expectTapes(const PlanResult& plan, std::size_t tapes, double lengthMm) {
  const plan::ToolpathStatistics& s = plan.job.report.toolpath;
  EXPECT_EQ(s.tapes, tapes);
  EXPECT_NEAR(s.tapeMm, static_cast<double>(tapes) * lengthMm,
              0.005 * static_cast<double>(tapes) * lengthMm);
  EXPECT_GE(s.tapeCoveredFraction, 0.9);
  EXPECT_EQ(s.tapeBareMm, 0.0);
  ASSERT_EQ(plan.checked.size(), 1u);
  const replay::Verification& verdict = plan.checked[0]->verdict;
  EXPECT_TRUE(plan.checked[0]->passed) << reasons(plan);
  EXPECT_NEAR(verdict.tapeMm3, s.tapeMm * 5.0 * 0.08, 0.002 * verdict.tapeMm3);
  EXPECT_EQ(eventsOf(*plan.job.trajectory, plan::EventKind::Cut), tapes);
  EXPECT_EQ(eventsOf(*plan.job.trajectory, plan::EventKind::ToolChange), 2 * tapes);
}

TEST(FibrePlans, ADumbbellWithFiveTapes) {
  expectTapes(
      planPart(fibreRequest("sample:dumbbell", "flat",
                            {{"layerHeightMm", "0.5"}, {"fibreCount", "1"}, {"fibreEndMm", "7.5"}}),
               {}),
      5, 150.0);
}

TEST(FibrePlans, ABarWithNineTapes) {
  expectTapes(
      planPart(fibreRequest("sample:bar", "flat",
                            {{"layerHeightMm", "0.5"}, {"fibreCount", "1"}, {"fibreEndMm", "5"}}),
               {}),
      9, 240.0);
}

TEST(FibrePlans, ATapeToolPrintsNoPart) {
  PlanRequest request = fibreRequest("sample:bar", "flat", {});
  request.choices.tools = {{"tape-5"}};
  EXPECT_THROW(planPart(request, {}), base::Error);
  request.choices.tools = {{"fdm-1.0"}};
  EXPECT_THROW(planPart(request, {}), base::Error) << "no tool lays tape";
}

} // namespace
} // namespace voluta::pipeline
