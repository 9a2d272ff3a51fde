// Parts with stitches (Castelli 6.2, 6.3) from the mesh to the replayed program.
#include "helpers/given_parameters.h"
#include "pipeline/checked_program.h"
#include "pipeline/road.h"

#include "base/files.h"
#include "base/run_context.h"
#include "helpers/loaded_box.h"
#include "helpers/temporary_folder.h"
#include "pipeline/plan_reasons.h"
#include "program/dialect.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using test::reasons;

// A block with one pocket in its middle.
PlanRequest stitchedRequest(std::vector<std::string> formats) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  PlanRequest request;
  request.item().loaded = test::loadedBox({-13, -13, 0}, {13, 13, 12});
  request.choices.tools = {{"fdm-1.0"}};
  request.choices.formats = std::move(formats);
  request.choices.item().mode = "flat";
  test::giveParameters(request.choices, {{"layerHeightMm", "1"},
                                         {"stitchSpacing", "40"},
                                         {"stitchLayers", "9"},
                                         {"output.proof", "false"}});
  return request;
}

std::vector<std::string> formatsWithShots() {
  std::vector<std::string> ids;
  for (const program::Dialect& dialect : program::dialects())
    if (std::ranges::find(dialect.events, plan::EventKind::Shot) != dialect.events.end())
      ids.emplace_back(dialect.id);
  return ids;
}

const PlanResult& stitched() {
  static const PlanResult kPlan = planPart(stitchedRequest(formatsWithShots()), {});
  return kPlan;
}

TEST(StitchedPlans, EveryDialectThatExtrudesAtRestFillsThePocket) {
  const PlanResult& plan = stitched();
  const plan::ToolpathStatistics& s = plan.job.report.toolpath;
  EXPECT_EQ(s.shots, 1u);
  EXPECT_NEAR(s.shotMm3, 1.15 * 184.3, 0.1);
  EXPECT_GE(plan.checked.size(), 8u);
  for (const auto& checked : plan.checked) {
    EXPECT_TRUE(checked->verdict.passed) << checked->program.format << "\n" << reasons(plan);
    EXPECT_NEAR(checked->verdict.massRatio, plan.checked[0]->verdict.massRatio, 0.002);
  }
  const auto shots = std::ranges::count(plan.job.trajectory->events, plan::EventKind::Shot,
                                        &plan::TrajectoryEvent::kind);
  EXPECT_EQ(shots, 1);
}

// A program without its shot, or with another one, is refused.
TEST(StitchedPlans, AProgramWithAnotherShotIsRefused) {
  const test::TemporaryFolder folder;
  for (const auto& checked : stitched().checked) {
    if (checked->program.format != "gcode" && checked->program.format != "gcode-extended")
      continue;
    const std::string text = checked->program.files.front().text;
    const std::size_t shot = text.find("; shot"), from = text.find("G1 E", shot),
                      end = text.find('\n', from);
    ASSERT_LT(end, text.size());
    const std::string line = text.substr(from, end - from);
    const auto passes = [&](const std::string& instead) {
      base::writeFile(folder / checked->program.files.front().name,
                      text.substr(0, from) + instead + text.substr(end));
      return verifyProgram(folder / checked->program.files.front().name, stitched().job, {})
          .replay.passed;
    };
    EXPECT_TRUE(passes(line));
    EXPECT_FALSE(passes("")) << checked->program.format;
    EXPECT_FALSE(passes("G1 E40 F60")) << checked->program.format;
  }
}

TEST(StitchedPlans, WithoutThemNothingChanges) {
  PlanRequest request = stitchedRequest({"gcode"});
  request.choices.item().parameters.erase("stitchSpacing");
  const PlanResult plan = planPart(request, {});
  EXPECT_EQ(plan.job.report.toolpath.shots, 0u);
  EXPECT_TRUE(plan.checked.at(0)->verdict.passed) << reasons(plan);
}

} // namespace
} // namespace voluta::pipeline
