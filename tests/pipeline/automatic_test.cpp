// Mode auto: which ways are tried, and which is taken.
#include "curved/decomposition.h"
#include "helpers/given_parameters.h"
#include "pipeline/automatic.h"
#include "pipeline/checked_program.h"

#include "base/error.h"
#include "helpers/shapes.h"
#include "modes/mode_table.h"
#include "pipeline/box_request.h"
#include "pipeline/resolved.h"
#include "pipeline/road.h"
#include "pipeline/search_texts.h"
#include "pipeline/stage_options.h"
#include "pipeline/stage_runner.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

using namespace voluta;
using pipeline::automaticChoices;
using pipeline::resolved;

namespace {

project::Choices automatic() {
  project::Choices choices;
  choices.item().automatic = true;
  return choices;
}

pipeline::PlanRequest automaticRequest() {
  pipeline::PlanRequest request = test::boxRequest();
  request.choices.item().automatic = true;
  request.choices.formats = {"urscript"};
  return request;
}

// Over nothing: no way but one with supports gets to it.
pipeline::PlanRequest plateInTheAir() {
  geometry::TriangleMesh part = test::box({-5, -5, 0}, {5, 5, 20});
  test::append(part, test::box({20, -8, 12}, {36, 8, 16}));
  pipeline::PlanRequest request = automaticRequest();
  request.item().loaded =
      project::loadedFrom("air.stl", std::make_shared<geometry::TriangleMesh>(part), {}, true, {});
  return request;
}

// The report, the choices and the plan name the same way with the same values.
void expectConsistent(const pipeline::PlanResult& result) {
  const project::Report& report = result.job.report;
  const project::ChosenReport& chosen = report.item().chosen;
  const auto taken = std::ranges::find(report.item().tried, true, &project::TriedReport::taken);
  ASSERT_NE(taken, report.item().tried.end());
  EXPECT_EQ(std::ranges::count(report.item().tried, true, &project::TriedReport::taken), 1);
  EXPECT_EQ(chosen.strategy, taken->strategy);
  EXPECT_EQ(base::english(chosen.name), base::english(taken->name));
  EXPECT_EQ(chosen.mode, taken->mode);
  EXPECT_EQ(chosen.platform, taken->platform);
  EXPECT_EQ(chosen.mode, report.item().decomposition.mode);
  EXPECT_EQ(chosen.strategy, result.job.choices.item().automaticStrategy);
  const project::Choices hand = resolved(result.job.choices);
  EXPECT_EQ(chosen.mode, hand.item().mode);
  EXPECT_EQ(chosen.platform, hand.item().platform.text());
  EXPECT_EQ(chosen.supports, pipeline::parameterValues(hand).text("supports"));
  EXPECT_EQ(chosen.layerHeightMm, result.tooling().first().process.layerHeightMm);
  for (const project::TriedReport& tried : report.item().tried) {
    EXPECT_FALSE(tried.name.empty());
    EXPECT_TRUE(tried.taken || !tried.reason.empty()) << base::english(tried.name);
  }
  EXPECT_EQ(pipeline::rejectedTexts(report.item()).size(), report.item().tried.size() - 1);
}

} // namespace

TEST(Automatic, WaysAreOfKnownModesAndPlatformsTheyTake) {
  ASSERT_FALSE(pipeline::automaticStrategies().empty());
  for (const pipeline::AutomaticStrategy& strategy : pipeline::automaticStrategies()) {
    const modes::Mode* mode = modes::modeNamed(strategy.mode);
    ASSERT_NE(mode, nullptr) << strategy.mode;
    EXPECT_TRUE(project::Platform(strategy.platform).isForAnyOf(mode->platforms)) << strategy.mode;
    for (const auto& [key, text] : strategy.parameters)
      EXPECT_TRUE(modes::takesParameter(*mode, key)) << strategy.mode << ": " << key;
  }
}

// The ways depend on the tilt of a cell, not on its name.
TEST(Automatic, AnArmThatStaysUprightGetsLevelLayersAtOnce) {
  project::Choices choices = automatic();
  choices.cell = "t3";
  const auto ways = automaticChoices(choices);
  ASSERT_EQ(ways.size(), 3u);
  EXPECT_EQ(ways[2].item().automaticStrategy, pipeline::kTerraced);
  EXPECT_EQ(ways[0].item().automaticStrategy, "flat");
  EXPECT_EQ(resolved(ways[0]).item().parameters.at("supports"), "auto");
  EXPECT_EQ(ways[1].item().automaticStrategy, "flat-low");
  choices.cell = "rv2f-moving";
  EXPECT_EQ(automaticChoices(choices).front().item().mode, "curved");
}

TEST(Automatic, WaysKeepTheirIdsWhenOthersAreInserted) {
  std::set<std::string_view> ids;
  for (const pipeline::AutomaticStrategy& strategy : pipeline::automaticStrategies())
    EXPECT_TRUE(ids.insert(strategy.id).second) << strategy.id;
  project::Choices choices = automatic();
  choices.item().mode = "flat";
  choices.item().platform = project::Platform("cell");
  choices.item().automaticStrategy = "flat-low";
  EXPECT_TRUE(resolved(choices).item().parameters.contains("layerHeightMm"));
  choices.item().automaticStrategy = "flat";
  EXPECT_FALSE(resolved(choices).item().parameters.contains("layerHeightMm"));
  choices.item().automaticStrategy = "gone"; // the first that has this mode and platform
  EXPECT_FALSE(resolved(choices).item().parameters.contains("layerHeightMm"));
  EXPECT_EQ(resolved(choices).item().parameters.at("supports"), "auto");
}

// An opened job is judged, resumed and drawn with the process that it was planned with.
TEST(Automatic, AnOpenedJobHasTheLayerHeightOfItsWay) {
  pipeline::PlanRequest request = automaticRequest();
  request.item().loaded = test::loadedBox({-5, -5, 0}, {5, 5, 4});
  request.choices.item().mode = "flat";
  request.choices.item().platform = project::Platform("cell");
  request.choices.item().automaticStrategy = "flat-low";
  request.until = project::Stage::Decompose; // in the way that the choices name
  const pipeline::PlanResult planned = pipeline::planPart(request, {});
  const double heightMm = planned.tooling().first().process.layerHeightMm;
  EXPECT_LT(heightMm, process::loadProcess(request.choices.tool().process).layerHeightMm);
  const pipeline::PlanResult opened = pipeline::resultOf(planned.job);
  EXPECT_EQ(opened.tooling().first().process.layerHeightMm, heightMm);
  EXPECT_EQ(opened.resolved().values.text("supports"), "auto");
}

TEST(Automatic, PlanByHandDiffersFromTheFirstWay) {
  pipeline::PlanRequest request = automaticRequest();
  request.choices.item().automatic = false;
  for (const char* platform : {"fit", "fit:10"}) {
    request.choices.item().platform = project::Platform(platform);
    const project::StageKeys hand = pipeline::stageKeys(request);
    pipeline::PlanRequest left = request;
    left.choices.item().automatic = true;
    const project::Choices first = automaticChoices(left.choices).front();
    EXPECT_EQ(pipeline::strategyOrFirst(left.choices).item().automaticStrategy,
              first.item().automaticStrategy);
    EXPECT_NE(pipeline::stageKeys(left), hand) << platform;
    const project::StageKeys begun = pipeline::stageKeys(left);
    left.choices = first;
    EXPECT_EQ(pipeline::stageKeys(left), begun);
  }
  // The way that was taken keeps its name.
  for (const project::Choices& strategy : automaticChoices(automaticRequest().choices))
    EXPECT_EQ(pipeline::strategyOrFirst(strategy).item().automaticStrategy,
              strategy.item().automaticStrategy);
  EXPECT_FALSE(pipeline::strategyOrFirst(request.choices).item().automatic);
}

TEST(Automatic, WaysSuitTheCell) {
  for (const project::Choices& strategy : automaticChoices(automatic()))
    EXPECT_FALSE(modes::findMode(strategy.item().mode).aroundRod) << strategy.item().mode;
  project::Choices lathe = automatic();
  lathe.cell = "lathe";
  lathe.tool().process = "fdm-0.35";
  for (const project::Choices& strategy : automaticChoices(lathe))
    EXPECT_TRUE(modes::findMode(strategy.item().mode).aroundRod) << strategy.item().mode;
}

TEST(Automatic, APlatformOfTheUsersStays) {
  project::Choices choices = automatic();
  choices.item().platform = project::Platform("disc:150");
  choices.item().platformStays = true;
  for (const project::Choices& strategy : automaticChoices(choices))
    EXPECT_EQ(strategy.item().platform.text(), "disc:150");
  choices.item().platform = project::Platform("rod:5x200");
  try {
    automaticChoices(choices);
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
  }
}

TEST(Automatic, WaysKeepParametersChangedByTheUser) {
  project::Choices choices = automatic();
  choices.item().parameters["supports"] = "none";
  for (project::Choices strategy : automaticChoices(choices)) {
    EXPECT_EQ(strategy.item().parameters, choices.item().parameters);
    const project::Choices hand = pipeline::resolved(strategy);
    EXPECT_FALSE(hand.item().automatic);
    EXPECT_EQ(hand.item().parameters.at("supports"), "none");
  }
}

TEST(Automatic, FlatLayersAreTriedOnceMoreInLowOnes) {
  std::vector<std::string> heights;
  for (const project::Choices& strategy : automaticChoices(automatic()))
    if (strategy.item().mode == "flat" &&
        strategy.item().automaticStrategy != pipeline::kTerraced) {
      const project::Choices hand = pipeline::resolved(strategy);
      EXPECT_EQ(hand.item().parameters.at("supports"), "auto");
      heights.push_back(hand.item().parameters.contains("layerHeightMm")
                            ? hand.item().parameters.at("layerHeightMm")
                            : "usual");
    }
  EXPECT_EQ(heights, (std::vector<std::string>{"usual", "0.5"}));
  project::Choices given = automatic();
  given.item().parameters["layerHeightMm"] = "0.6";
  int flat = 0;
  for (const project::Choices& strategy : automaticChoices(given))
    flat +=
        strategy.item().mode == "flat" && strategy.item().automaticStrategy != pipeline::kTerraced;
  EXPECT_EQ(flat, 1) << "whoever says how high layers are is not asked twice";
}

TEST(Automatic, AllWaysDiffer) {
  const auto differ = [](const std::vector<project::Choices>& ways) {
    for (std::size_t i = 0; i < ways.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const project::Choices a = pipeline::resolved(ways[i]), b = pipeline::resolved(ways[k]);
        if (a.item().mode == b.item().mode && a.item().platform == b.item().platform &&
            a.item().parameters == b.item().parameters)
          return false;
      }
    return true;
  };
  const std::vector<project::Choices> all = automaticChoices(automatic());
  EXPECT_EQ(all.size(), pipeline::automaticStrategies().size());
  EXPECT_TRUE(differ(all));
  for (const char* supports : {"none", "auto"}) {
    project::Choices choices = automatic();
    choices.item().parameters["supports"] = supports;
    const std::vector<project::Choices> ways = automaticChoices(choices);
    EXPECT_LT(ways.size(), all.size());
    EXPECT_TRUE(differ(ways));
  }
}

TEST(Automatic, ABoxIsPrintedInFlatLayers) {
  const pipeline::PlanResult result = pipeline::planPart(automaticRequest(), {});
  const project::Job& job = result.job;
  EXPECT_TRUE(pipeline::nothingBlocks(job.report));
  ASSERT_EQ(job.report.item().tried.size(), 1U);
  EXPECT_TRUE(job.report.item().tried.front().passed && job.report.item().tried.front().taken);
  EXPECT_TRUE(job.report.item().tried.front().reason.empty());
  EXPECT_TRUE(job.choices.item().automatic);
  EXPECT_EQ(job.choices.item().mode, "flat");
  EXPECT_EQ(job.choices.item().automaticStrategy, pipeline::kTerraced);
  EXPECT_TRUE(job.choices.item().parameters.empty()); // a way's own are not the user's
  // A plan is up to date for the choices that it resulted in.
  pipeline::PlanRequest again = automaticRequest();
  again.choices = job.choices;
  EXPECT_EQ(pipeline::stageKeys(again), job.keys());
}

// A further format needs a program, not another search.
TEST(Automatic, TheWayStaysWhenFormatsChange) {
  pipeline::StageCache cache;
  pipeline::PlanRequest request = plateInTheAir();
  const pipeline::PlanResult first = pipeline::planPart(request, {}, &cache);
  ASSERT_TRUE(pipeline::nothingBlocks(first.job.report));
  ASSERT_GT(first.job.report.item().tried.size(), 1u);
  request.choices = first.job.choices;
  request.choices.formats.emplace_back("gcode-extended");
  int ways = 0;
  const auto onStrategy = [&](const pipeline::StrategyProgress&) { ++ways; };
  const pipeline::PlanResult second =
      pipeline::planPart(request, {}, &cache, {.onStrategy = onStrategy});
  EXPECT_EQ(ways, 0);
  EXPECT_EQ(second.checked.size(), 2u);
  EXPECT_EQ(second.job.trajectory, first.job.trajectory) << "not planned again";
  EXPECT_EQ(second.job.choices.item().automaticStrategy,
            first.job.choices.item().automaticStrategy);
  expectConsistent(second);
  request.choices.item().parameters["walls"] = "3"; // concerns the tool-paths
  pipeline::planPart(request, {}, &cache, {.onStrategy = onStrategy});
  EXPECT_GT(ways, 0);
}

TEST(Automatic, FindingThatBlocksAWayIsGiven) {
  const pipeline::PlanResult result = pipeline::planPart(plateInTheAir(), {});
  ASSERT_FALSE(result.job.report.item().tried.empty());
  const project::TriedReport& first = result.job.report.item().tried.front();
  EXPECT_EQ(first.mode, pipeline::automaticStrategies().front().mode);
  EXPECT_FALSE(first.stage.empty());
  EXPECT_FALSE(first.reason.empty());
  int taken = 0;
  for (const project::TriedReport& tried : result.job.report.item().tried) {
    EXPECT_TRUE(tried.passed || !tried.reason.empty());
    EXPECT_TRUE(!tried.taken || tried.mode == result.job.choices.item().mode);
    taken += tried.taken ? 1 : 0;
  }
  EXPECT_EQ(taken, 1);
  const std::string json = project::reportJson(result.job.report);
  EXPECT_EQ(project::readReportJson(json).item().tried.size(),
            result.job.report.item().tried.size());
}

TEST(Automatic, WaysAreNamedByTheirMethod) {
  std::vector<std::string> names;
  for (const project::Choices& strategy : automaticChoices(automatic()))
    names.push_back(base::english(pipeline::nameOfStrategy(strategy)));
  EXPECT_EQ(names, (std::vector<std::string>{
                       "curved layers", "pieces", "curved layers with supports",
                       "flat layers with supports", "flat layers with supports, 0.5 mm each",
                       "curved layers on a pedestal", "flat layers"}));
  project::Choices none = automatic();
  none.item().parameters["supports"] = "none";
  for (const project::Choices& strategy : automaticChoices(none))
    EXPECT_EQ(base::english(pipeline::nameOfStrategy(strategy)).find("supports"),
              std::string::npos);
  EXPECT_EQ(base::english(pipeline::nameOfStrategy(resolved(none))), "Curved layers");
  EXPECT_EQ(base::english(pipeline::tryingText({"pieces"_text, 2, 4})), "Trying pieces (2 of 4)");
}

TEST(Automatic, TextsForABoxAreConsistent) {
  std::vector<std::string> tried;
  const auto note = [&](const pipeline::StrategyProgress& strategy) {
    tried.push_back(base::english(strategy.name));
    EXPECT_EQ(strategy.count, pipeline::automaticStrategies().size());
  };
  const pipeline::PlanResult result =
      pipeline::planPart(automaticRequest(), {}, nullptr, {.onStrategy = note});
  expectConsistent(result);
  EXPECT_EQ(tried, (std::vector<std::string>{"flat layers"}));
  EXPECT_EQ(
      base::english(pipeline::chosenText(result.job.report.item())),
      "Chosen: flat layers (layer height 0.8 mm, supports: none, platform: plate of the cell)");
}

TEST(Automatic, TextsAreConsistentWhereWaysAreRejected) {
  const pipeline::PlanResult result = pipeline::planPart(plateInTheAir(), {});
  expectConsistent(result);
  EXPECT_GT(result.job.report.item().tried.size(), 1U);
}

// The field takes most of the time of curved layers: it is not fitted where voxels are missed.
TEST(Automatic, AWayEndsAsSoonAsItIsBlocked) {
  pipeline::PlanRequest request = plateInTheAir();
  request.choices = automaticChoices(request.choices).front();
  pipeline::StageCache cache;
  pipeline::Trial trial;
  std::vector<project::Stage> shown;
  const auto note = [&](project::Stage stage, const pipeline::PlanResult&) {
    shown.push_back(stage);
  };
  const pipeline::PlanResult tried =
      pipeline::planChosenStrategy(request, {}, &cache, {.onStage = note}, &trial);
  ASSERT_TRUE(trial.rejection);
  EXPECT_EQ(trial.rejection->stage, project::Stage::Decompose);
  EXPECT_TRUE(trial.rejection->finding.blocking);
  ASSERT_NE(tried.job.item().decomposition(), nullptr);
  EXPECT_GT(tried.job.item().decomposition()->missedVoxels, 0U);
  EXPECT_TRUE(tried.job.item().decomposition()->field.empty());
  EXPECT_EQ(shown, (std::vector<project::Stage>{project::Stage::Load}));
  // Planned for itself it is whole, with the same first reason.
  request.until = project::Stage::Layers;
  const pipeline::PlanResult whole = pipeline::planChosenStrategy(request, {}, &cache, {});
  EXPECT_FALSE(whole.job.item().decomposition()->field.empty());
  EXPECT_EQ(whole.job.reached, project::Stage::Layers);
  const auto blocking = std::ranges::find_if(whole.job.report.findings, &plan::Finding::blocking);
  ASSERT_NE(blocking, whole.job.report.findings.end());
  EXPECT_EQ(base::english(plan::reasonOf(*blocking)),
            base::english(plan::reasonOf(trial.rejection->finding)));
}

TEST(Automatic, APartThatNoWayTakesIsAnError) {
  pipeline::PlanRequest request = automaticRequest();
  request.choices.tool().process = "no such process";
  EXPECT_THROW(pipeline::planPart(request, {}), base::Error);
}

// Growth misses nothing of a box, so columns would not change the blocking finding.
TEST(Automatic, NoWayIsTriedThatComesToTheSame) {
  pipeline::PlanRequest request = automaticRequest();
  // A skin over nothing.
  test::giveParameters(request.choices,
                       {{"infillDensity", "0"}, {"topLayers", "1"}, {"bottomLayers", "1"}});
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  EXPECT_FALSE(pipeline::nothingBlocks(result.job.report));
  expectConsistent(result);
  const std::string said = base::english(pipeline::chosenText(result.job.report.item()));
  EXPECT_TRUE(said.starts_with("No way of building passes; the best one is shown: ")) << said;
  EXPECT_EQ(result.job.reached, project::Stage::Replay);
  EXPECT_FALSE(result.checked.empty());
  EXPECT_EQ(result.job.report.item().tried.size(), pipeline::automaticStrategies().size() - 1);
  int curved = 0;
  for (const project::TriedReport& tried : result.job.report.item().tried)
    curved += tried.mode == "curved" && tried.platform == "cell";
  EXPECT_EQ(curved, 1);
}

// A pocket whose roof is wider than the material bridges, with flat layers and without supports.
TEST(Automatic, LeastUnsupportedWayIsTakenIfAllAreUnsupported) {
  geometry::TriangleMesh part = test::box({-15, -15, 0}, {15, 15, 5});
  test::append(part, test::box({-15, -15, 4.9}, {-7.5, 15, 26}));
  test::append(part, test::box({7.5, -15, 4.9}, {15, 15, 26}));
  test::append(part, test::box({-7.6, -15, 4.9}, {7.6, 8, 26}));
  test::append(part, test::box({-15, -15, 20}, {15, 15, 26}));
  pipeline::PlanRequest request = automaticRequest();
  request.item().loaded = project::loadedFrom(
      "pocket.stl", std::make_shared<geometry::TriangleMesh>(part), {}, true, {});
  request.choices.item().parameters["supports"] = "none";
  request.choices.cell = "t3";
  request.choices.formats = {"spel"};
  std::string lastShown;
  const auto noteShown = [&](project::Stage, const pipeline::PlanResult& soFar) {
    lastShown = soFar.job.choices.item().automaticStrategy;
  };
  const pipeline::PlanResult result =
      pipeline::planPart(request, {}, nullptr, {.onStage = noteShown});
  const project::Report& report = result.job.report;
  EXPECT_TRUE(pipeline::nothingBlocks(report));
  EXPECT_GT(report.replay.longestUnsupportedMm, result.tooling().first().process.bridgeMm);
  EXPECT_EQ(lastShown, result.job.choices.item().automaticStrategy);
  ASSERT_EQ(report.item().tried.size(), 2U);
  int taken = 0;
  for (const project::TriedReport& tried : report.item().tried) {
    EXPECT_TRUE(tried.passed);
    EXPECT_FALSE(tried.reason.empty());
    taken += tried.taken;
  }
  EXPECT_EQ(taken, 1);
  // By hand both: neither has less unsupported length.
  for (const project::Choices& strategy : automaticChoices(request.choices)) {
    pipeline::PlanRequest one = request;
    one.choices = resolved(strategy);
    EXPECT_GE(pipeline::planPart(one, {}).job.report.replay.longestUnsupportedMm,
              report.replay.longestUnsupportedMm);
  }
}
