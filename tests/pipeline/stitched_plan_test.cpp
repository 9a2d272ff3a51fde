// Parts with stitches (Castelli 6.2, 6.3) from the mesh to the replayed program.
#include "pipeline/road.h"

#include "base/run_context.h"
#include "helpers/loaded_box.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/verification.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

// A block with one pocket in its middle.
PlanRequest stitchedRequest(std::vector<std::string> formats) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  PlanRequest request;
  request.item().loaded = test::loadedBox({-13, -13, 0}, {13, 13, 12});
  request.choices.tools = {{"fdm-1.0"}};
  request.choices.formats = std::move(formats);
  request.choices.item().mode = "flat";
  request.choices.item().parameters = {{"layerHeightMm", "1"},
                                       {"stitchSpacing", "40"},
                                       {"stitchLayers", "9"},
                                       {"output.proof", "false"}};
  return request;
}

std::string reasons(const PlanResult& plan) {
  std::string all;
  for (const plan::Finding& finding : plan.job.report.findings)
    all += plan::englishReason(finding) + "\n";
  return all;
}

TEST(StitchedPlans, EveryDialectThatExtrudesAtRestFillsThePocket) {
  std::vector<std::string> formats;
  for (const char* id : {"urscript", "gcode-extended", "gcode"})
    formats.emplace_back(id);
  const PlanResult plan = planPart(stitchedRequest(formats), {});
  const plan::ToolpathStatistics& s = plan.job.report.toolpath;
  EXPECT_EQ(s.shots, 1u);
  EXPECT_NEAR(s.shotMm3, 1.15 * 184.3, 0.1);
  ASSERT_EQ(plan.checked.size(), formats.size());
  for (const auto& checked : plan.checked)
    EXPECT_TRUE(checked->passed) << reasons(plan);
  const auto shots = std::ranges::count(plan.job.trajectory->events, plan::EventKind::Shot,
                                        &plan::TrajectoryEvent::kind);
  EXPECT_EQ(shots, 1);
}

TEST(StitchedPlans, WithoutThemNothingChanges) {
  PlanRequest request = stitchedRequest({"gcode"});
  request.choices.item().parameters.erase("stitchSpacing");
  const PlanResult plan = planPart(request, {});
  EXPECT_EQ(plan.job.report.toolpath.shots, 0u);
  EXPECT_TRUE(plan.checked.at(0)->passed) << reasons(plan);
}

} // namespace
} // namespace voluta::pipeline
