// Settings of planned layers and tool-paths have no effect on the tool-paths of a file: the window
// hides them, a plan notes them.
#include "pipeline/planned_parameters.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/given_parameters.h"
#include "helpers/other_text.h"
#include "helpers/temporary_folder.h"
#include "modes/mode_table.h"
#include "pipeline/road.h"
#include "pipeline/stage_cache.h"
#include "pipeline/stage_options.h"
#include "plan/tool_plan.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

// Two layers of a square.
std::shared_ptr<const project::LoadedPart> slicedSquare() {
  static const auto kSquare = [] {
    std::string text = "M83\nG90\n";
    for (const char* z : {"0.8", "1.6"})
      text += std::string(";LAYER_CHANGE\nG1 Z") + z +
              " F3000\nG0 X0 Y0\n;TYPE:Perimeter\nG1 X12 Y0 E4.2 F1200\nG1 X12 Y12 E4.2\n"
              "G1 X0 Y12 E4.2\nG1 X0 Y0 E4.2\n";
    const test::TemporaryFolder folder;
    base::writeFile(folder / "square.gcode", text);
    return project::loadPart((folder / "square.gcode").string(), true, {});
  }();
  return kSquare;
}

PlanResult plannedWith(const std::map<std::string, std::string>& parameters, project::Stage until) {
  PlanRequest request;
  request.item().loaded = slicedSquare();
  request.choices.item().mode = "flat";
  test::giveParameters(request.choices, parameters);
  request.until = until;
  static StageCache cache; // Most settings leave the first stages as they are
  return planPart(request, {}, &cache);
}

std::vector<std::string> notesWith(const std::map<std::string, std::string>& parameters) {
  return base::english(
      plannedWith(parameters, project::Stage::Load).job.report.item().model.repairs);
}

TEST(PlannedParameters, DoNotChangeTheToolPathsOfAFile) {
  const auto usual = plannedWith({}, project::Stage::Toolpath).job;
  const base::ParameterTable planned = plannedParameters(modes::findMode("flat"));
  std::size_t compared = 0;
  for (const base::ParameterSpec& spec : planned.specs()) {
    const bool isTool = spec.key == "tool" || spec.key.ends_with("Tool"); // there is one
    if (isTool || spec.type == base::ParameterType::Text)
      continue;
    project::Job other;
    try {
      other = plannedWith({{spec.key, test::otherText(spec)}}, project::Stage::Toolpath).job;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ErrorCode::Usage) << spec.key;
      continue; // the process does not allow that value
    }
    ++compared;
    ASSERT_TRUE(other.toolPlan) << spec.key;
    EXPECT_EQ(other.toolPlan->position, usual.toolPlan->position) << spec.key;
    EXPECT_EQ(other.toolPlan->speedMmPerS, usual.toolPlan->speedMmPerS) << spec.key;
    EXPECT_EQ(other.toolPlan->widthMm, usual.toolPlan->widthMm) << spec.key;
  }
  EXPECT_GT(compared, 40u);
}

TEST(PlannedParameters, LeaveTheSettingsThatMatter) {
  const base::ParameterTable planned = plannedParameters(modes::findMode("flat"));
  const base::ParameterTable all = allParameters();
  for (const base::ParameterSpec& spec : planned.specs()) {
    ASSERT_TRUE(all.find(spec.key)) << spec.key;
    EXPECT_EQ(all.find(spec.key)->scope, spec.scope) << spec.key;
  }
  for (const char* key : {"walls", "infillDensity", "supports", "brimWidthMm", "seam", "prime"})
    EXPECT_TRUE(planned.find(key)) << key;
  for (const char* key :
       {"givenToolPaths", "pathsOn", "stepMm", "layerHeightMm", "liftMm", "orient"})
    EXPECT_FALSE(planned.find(key)) << key;
  EXPECT_FALSE(plannedParameters(modes::findMode("lathe")).find("rodProfile"))
      << "it makes the platform";
}

TEST(PlannedParameters, AreNotedWhereTheyHaveNoEffect) {
  const auto has = [](const std::vector<std::string>& notes, const std::string& note) {
    return std::ranges::find(notes, note) != notes.end();
  };
  EXPECT_TRUE(has(notesWith({{"walls", "3"}, {"brimWidthMm", "5"}, {"liftMm", "4"}}),
                  "2 settings have no effect on the tool-paths of a file: brimWidthMm, walls"));
  EXPECT_TRUE(has(notesWith({{"walls", "3"}}),
                  "1 setting has no effect on the tool-paths of a file: walls"));
  EXPECT_TRUE(std::ranges::none_of(notesWith({{"liftMm", "4"}}), [](const std::string& note) {
    return note.find("no effect") != std::string::npos;
  }));
}

} // namespace
} // namespace voluta::pipeline
