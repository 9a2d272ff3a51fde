// Jobs with several tools, from the mesh to the replayed programs.
#include "base/error.h"
#include "base/files.h"
#include "box_request.h"
#include "helpers/given_parameters.h"
#include "motion/motion_options.h"
#include "pipeline/checked_program.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/stage_options.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace voluta::pipeline {
namespace {

using test::reasons;

using Json = nlohmann::json;

const std::vector<std::string> kFormats = {"urscript", "rapid",    "krl",   "melfa",
                                           "spel",     "tmscript", "gcode", "gcode-extended"};

PlanRequest request(std::size_t parts = 1) {
  PlanRequest request;
  request.items.resize(parts);
  request.choices.items.resize(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    request.item(i).loaded = test::loadedBox({-9, -8, 0}, {9, 8, 6});
    request.choices.item(i).mode = "flat";
    request.choices.item(i).placement.centreMm.x() = 60.0 * static_cast<double>(i) - 30.0;
  }
  request.choices.cell = "ur5-moving";
  request.choices.tools = {{"fdm-1.0"}, {"fdm-1.0"}};
  request.choices.formats = {"urscript"};
  return request;
}

void expectPassed(const PlanResult& plan, const std::vector<std::string>& formats) {
  ASSERT_EQ(plan.checked.size(), formats.size());
  for (const auto& checked : plan.checked)
    EXPECT_TRUE(checked->verdict.passed) << checked->program.format << "\n" << reasons(plan);
}

TEST(SeveralTools, PartsByLayerNeedOneChangeALayer) {
  PlanRequest given = request(2);
  given.choices.item(1).parameters["tool"] = "2";
  given.choices.printOrder = layers::PrintOrder::ByLayer;
  given.choices.formats = kFormats;
  const PlanResult plan = planPart(given, {});
  expectPassed(plan, kFormats);
  const auto layers = static_cast<std::size_t>(plan.job.report.item().layers.count);
  EXPECT_GE(layers, 5u);
  EXPECT_EQ(plan.job.report.motion.toolChanges, layers);
}

TEST(SeveralTools, PartsOneAfterAnotherNeedOneChange) {
  PlanRequest given = request(2);
  given.choices.item(1).parameters["tool"] = "2";
  const PlanResult plan = planPart(given, {});
  expectPassed(plan, {"urscript"});
  EXPECT_EQ(plan.job.report.motion.toolChanges, 1u);
  const std::vector<process::ToolUse> uses = plan.tooling().usesOf(*plan.job.trajectory);
  EXPECT_NEAR(uses[0].printedMm3, uses[1].printedMm3, 0.01 * uses[0].printedMm3);
  EXPECT_DOUBLE_EQ(uses[0].purgedMm3, 0.0);
  EXPECT_DOUBLE_EQ(uses[1].purgedMm3, motion::MotionOptions{}.purge.changeMm3);
}

TEST(SeveralTools, TheInteriorIsFilledByItsTool) {
  for (const char* density : {"1", "0.4"}) {
    SCOPED_TRACE(density);
    PlanRequest given = request();
    given.item().loaded = test::loadedBox({-17, -15, 0}, {17, 15, 9});
    test::giveParameters(given.choices, {{"infillTool", "2"}, {"infillDensity", density}});
    given.choices.formats = {"gcode"};
    const PlanResult plan = planPart(given, {});
    expectPassed(plan, {"gcode"});
    std::set<plan::PathKind> kinds[2];
    for (const plan::ToolPath& path : plan.job.toolPlan->paths)
      kinds[path.tool].insert(path.kind);
    EXPECT_TRUE(kinds[0].contains(plan::PathKind::Wall));
    EXPECT_FALSE(kinds[1].contains(plan::PathKind::Wall));
    EXPECT_FALSE(kinds[1].empty());
    // Layers within the skins have both tools, those of the skins one.
    EXPECT_LT(plan.job.report.motion.toolChanges,
              static_cast<std::size_t>(plan.job.report.item().layers.count));
    EXPECT_GE(plan.job.report.motion.toolChanges, 3u);
  }
}

// A cell whose arm changes its tool in docks beside the plate.
std::string changerCell(const Json& docks) {
  Json cell = Json::parse(base::readFile(base::resourceFolder() / "cells/ur5-moving.json"));
  cell["id"] = "changer";
  cell["toolChange"] = {{"by", "changer"}, {"docks", docks}};
  return cell.dump();
}
Json dock(double firstDeg, double elbowDeg = -95.0) {
  return {{"beforeDeg", {firstDeg, -81.2, -82, -106.8, 90, -7.4}},
          {"inDeg", {firstDeg, -75, elbowDeg, -100, 90, -7.4}}};
}

TEST(SeveralTools, AChangerPutsAndTakesThemInItsDocks) {
  PlanRequest given = request(2);
  given.choices.item(1).parameters["tool"] = "2";
  given.choices.cell = changerCell(Json::array({dock(75), dock(95)}));
  given.choices.formats = {"urscript", "krl"};
  const PlanResult plan = planPart(given, {});
  expectPassed(plan, given.choices.formats);
  std::vector<plan::EventKind> kinds;
  for (const plan::TrajectoryEvent& event : plan.job.trajectory->events)
    kinds.push_back(event.kind);
  using enum plan::EventKind;
  EXPECT_EQ(kinds, (std::vector<plan::EventKind>{Release, ToolChange, Lock, Purge}));
}

TEST(SeveralTools, BadInputIsRefusedInOneLine) {
  const auto reasonOf = [](const PlanRequest& given) -> std::string {
    try {
      planPart(given, {});
    } catch (const base::Error& error) {
      return base::english(error.message());
    }
    return {};
  };
  PlanRequest noSuchTool = request();
  noSuchTool.choices.item().parameters["tool"] = "3";
  EXPECT_EQ(reasonOf(noSuchTool), "the job has no tool 3, it has 2");
  PlanRequest tooThick = request();
  tooThick.choices.tools[1] = {"fdm-0.4"};
  tooThick.choices.item().parameters["supportTool"] = "2";
  EXPECT_THAT(reasonOf(tooThick), testing::HasSubstr("tool 2 cannot print layers of 0.8 mm"));
  PlanRequest oneDock = request();
  oneDock.choices.cell = changerCell(Json::array({dock(75)}));
  EXPECT_EQ(reasonOf(oneDock), "cell changer has no dock for tool 2");
  PlanRequest inTable = request(2);
  inTable.choices.item(1).parameters["tool"] = "2";
  inTable.choices.cell = changerCell(Json::array({dock(75), dock(95, -150.0)}));
  EXPECT_THAT(reasonOf(inTable), testing::HasSubstr("does not get to the dock of tool 2"));
  PlanRequest tooMany = request();
  tooMany.choices.tools.resize(5);
  EXPECT_EQ(reasonOf(tooMany), "5 tools are too many for a job");
}

TEST(SeveralTools, AssignmentsReachTheLayers) {
  const auto keys = [](const std::string& key, const std::string& value) {
    PlanRequest given = request();
    test::giveParameter(given.choices, key, value);
    return stageKeys(given);
  };
  const project::StageKeys usual = stageKeys(request());
  for (const auto& [key, value] : {std::pair("supportTool", "2"), std::pair("infillTool", "2"),
                                   std::pair("pieceTools", "1,2")}) {
    const project::StageKeys changed = keys(key, value);
    for (std::size_t s = 0; s < project::kStageCount; ++s)
      EXPECT_EQ(changed[s] == usual[s], s < project::indexOf(project::Stage::Layers)) << key << s;
  }
}

TEST(SeveralTools, ARemovedToolLeavesItsWorkToTheFirst) {
  PlanRequest given = request(2);
  given.choices.tools.resize(3);
  test::giveParameters(given.choices, {{"tool", "2"}, {"pieceTools", "1, 2,3"}});
  given.choices.item(1).parameters = {
      {"supportTool", "3"}, {"infillTool", "0"}, {"layerEvents", "4 tool 2; 8 tool 3"}};
  removeTool(given.choices, 1);
  EXPECT_EQ(given.choices.tools.size(), 2u);
  EXPECT_EQ(given.choices.item(0).parameters.at("tool"), "1");
  EXPECT_EQ(given.choices.item(0).parameters.at("pieceTools"), "1,1,2");
  EXPECT_EQ(given.choices.item(1).parameters.at("supportTool"), "2");
  EXPECT_EQ(given.choices.item(1).parameters.at("infillTool"), "0");
  EXPECT_EQ(given.choices.item(1).parameters.at("layerEvents"), "4 tool 1; 8 tool 2");
}

} // namespace
} // namespace voluta::pipeline
