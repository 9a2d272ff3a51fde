// A job of two items: each is planned by itself up to its layers, which are then printed in order.
#include "base/error.h"
#include "layers/layer_stack.h"
#include "pipeline/box_request.h"
#include "pipeline/items/plate_parts.h"
#include "pipeline/road.h"
#include "pipeline/stage_cache.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"

#include "helpers/temporary_folder.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;
using project::Stage;

namespace {

// Two boxes, 40 mm apart, in flat layers.
pipeline::PlanRequest twoBoxes(layers::PrintOrder order) {
  pipeline::PlanRequest request = test::boxRequest();
  request.choices.item().automatic = false;
  request.choices.item().mode = "flat";
  request.choices.printOrder = order;
  request.items.push_back(request.item());
  request.choices.items.push_back(request.choices.item());
  request.choices.item(0).placement.centreMm = {-20.0, 0.0};
  request.choices.item(1).placement.centreMm = {20.0, 0.0};
  request.until = Stage::Toolpath;
  return request;
}

// The items in the order of their paths, each run of one item once.
std::vector<int> itemRuns(const plan::ToolPlan& plan) {
  std::vector<int> runs;
  for (const plan::ToolPath& path : plan.paths)
    if (!plan::isWaste(path.kind) && (runs.empty() || runs.back() != path.item))
      runs.push_back(path.item);
  return runs;
}

double middleX(const plan::ToolPlan& plan, int item) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      if (path.item == item && !plan::isWaste(path.kind)) {
        sum += plan.position[i].x();
        ++count;
      }
  return sum / static_cast<double>(count);
}

TEST(Items, OneAfterAnotherArePrintedWhole) {
  const pipeline::PlanResult result =
      pipeline::planPart(twoBoxes(layers::PrintOrder::OneAfterAnother), {});
  ASSERT_TRUE(result.job.toolPlan);
  const plan::ToolPlan& plan = *result.job.toolPlan;
  EXPECT_EQ(itemRuns(plan), (std::vector<int>{0, 1}));
  EXPECT_NEAR(middleX(plan, 0), -20.0, 1.0);
  EXPECT_NEAR(middleX(plan, 1), 20.0, 1.0);
  EXPECT_EQ(result.job.items.size(), 2u);
  EXPECT_EQ(result.job.report.item(0).layers.count, result.job.report.item(1).layers.count);
}

TEST(Items, ByLayerAlternate) {
  const pipeline::PlanResult result = pipeline::planPart(twoBoxes(layers::PrintOrder::ByLayer), {});
  ASSERT_TRUE(result.job.toolPlan);
  const int layers = result.job.report.item(0).layers.count;
  EXPECT_EQ(itemRuns(*result.job.toolPlan).size(), 2u * static_cast<std::size_t>(layers));
}

TEST(Items, AreCachedEachByItself) {
  pipeline::StageCache cache(4);
  pipeline::PlanRequest request = twoBoxes(layers::PrintOrder::OneAfterAnother);
  request.until = Stage::Layers;
  const pipeline::PlanResult first = pipeline::planPart(request, {}, &cache);
  request.choices.item(1).placement.centreMm.x() = 25.0;
  const pipeline::PlanResult moved = pipeline::planPart(request, {}, &cache);
  EXPECT_EQ(moved.job.item(0).layers, first.job.item(0).layers) << "the first item was not moved";
  EXPECT_NE(moved.job.item(1).layers, first.job.item(1).layers);
  EXPECT_NE(moved.job.keys(), first.job.keys());
}

// A cache keeps three results of a stage by default; each item has its own.
TEST(Items, AreAllFoundAgainForAnyCount) {
  pipeline::StageCache cache;
  pipeline::PlanRequest request = twoBoxes(layers::PrintOrder::OneAfterAnother);
  for (const double y : {-30.0, 30.0, 50.0}) {
    request.items.push_back(request.item());
    request.choices.items.push_back(request.choices.item());
    request.choices.items.back().placement.centreMm.y() = y;
  }
  request.until = Stage::Layers;
  const pipeline::PlanResult first = pipeline::planPart(request, {}, &cache);
  const pipeline::PlanResult again = pipeline::planPart(request, {}, &cache);
  for (std::size_t i = 0; i < request.items.size(); ++i)
    EXPECT_EQ(again.job.item(i).layers, first.job.item(i).layers) << i;
}

// A program is judged by each of its parts: a small part whose beads are missing is refused beside
// large ones.
TEST(Items, AreJudgedEachByItself) {
  pipeline::PlanRequest request = twoBoxes(layers::PrintOrder::OneAfterAnother);
  request.choices.item(1).scale = "0.5";
  request.until = Stage::Replay;
  request.choices.formats = {"gcode-extended"};
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  const project::ReplayReport& replay = result.job.report.replay;
  EXPECT_TRUE(replay.passed);
  ASSERT_EQ(replay.items.size(), 2u);
  for (const project::ItemReplayReport& item : replay.items) {
    EXPECT_GE(item.coveredFraction, 0.97);
    EXPECT_NEAR(item.massRatio, 1.0, 0.03);
  }
  ASSERT_EQ(result.job.report.toolpath.items.size(), 2u);
  EXPECT_NEAR(result.job.report.toolpath.items[0].materialMm3,
              8.0 * result.job.report.toolpath.items[1].materialMm3,
              0.1 * result.job.report.toolpath.items[0].materialMm3);
}

TEST(Items, HaveTheFiguresOfPartsPlannedAlone) {
  pipeline::PlanRequest request = twoBoxes(layers::PrintOrder::OneAfterAnother);
  request.choices.item(0).parameters["infillDensity"] = "0.3";
  request.choices.item(1).parameters["walls"] = "3";
  const pipeline::PlanResult both = pipeline::planPart(request, {});
  for (std::size_t i = 0; i < 2; ++i) {
    pipeline::PlanRequest alone = request;
    alone.items = {request.item(i)};
    alone.choices = project::onlyItem(request.choices, i);
    const plan::ToolpathStatistics one = pipeline::planPart(alone, {}).job.report.toolpath;
    const plan::ItemToolpaths& own = both.job.report.toolpath.items.at(i);
    EXPECT_NEAR(own.materialMm3, one.materialMm3, 0.01 * one.materialMm3) << i;
  }
  EXPECT_TRUE(both.job.toolPlan->fillOf(1).isSolid());
  EXPECT_FALSE(both.job.toolPlan->fillOf(0).isSolid());
}

TEST(Items, SwallowedPartsBlock) {
  pipeline::PlanRequest request = twoBoxes(layers::PrintOrder::OneAfterAnother);
  request.choices.item(1).placement.centreMm = request.choices.item(0).placement.centreMm;
  request.choices.item(1).scale = "0.3";
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  ASSERT_FALSE(result.job.report.findings.empty());
  EXPECT_EQ(result.job.report.findings.back().kind, plan::FindingKind::PartsOverlap);
  EXPECT_FALSE(result.job.toolPlan) << "nothing to plan until the parts are apart";
}

TEST(Items, SearchTheirWaysEachByItself) {
  pipeline::PlanRequest request = twoBoxes(layers::PrintOrder::OneAfterAnother);
  request.choices.item(0).automatic = true;
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  EXPECT_FALSE(result.job.report.item(0).tried.empty());
  EXPECT_FALSE(result.job.choices.item(0).automaticStrategy.empty());
  EXPECT_TRUE(result.job.report.item(1).tried.empty());
  EXPECT_TRUE(result.job.toolPlan);
}

TEST(Items, FindingsNameTheirPart) {
  pipeline::PlanRequest request = twoBoxes(layers::PrintOrder::OneAfterAnother);
  request.choices.item(1).scale = "0.04";
  request.until = Stage::Load;
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  ASSERT_FALSE(result.job.report.findings.empty());
  EXPECT_EQ(result.job.report.findings.front().item, 1);
}

TEST(Items, FindingsOfPathsAndMotionNameThePartAtTheirPlace) {
  pipeline::PlanRequest request = twoBoxes(layers::PrintOrder::OneAfterAnother);
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  plan::Findings findings{
      plan::makeFinding(plan::FindingKind::PatchWithoutBead, {}, Eigen::Vector3d(20, 0, 3)),
      plan::makeFinding(plan::FindingKind::PatchWithoutBead, {}, Eigen::Vector3d(0, 0, 3)),
      plan::makeFinding(plan::FindingKind::PatchWithoutBead)};
  pipeline::nameItems(findings, result.job.items, 1.0);
  EXPECT_EQ(findings[0].item, 1);
  EXPECT_EQ(findings[1].item, -1) << "between them";
  EXPECT_EQ(findings[2].item, -1) << "no place";
}

TEST(Items, AreReadBackFromAProject) {
  const test::TemporaryFolder folder;
  const pipeline::PlanResult result = pipeline::planPart(twoBoxes(layers::PrintOrder::ByLayer), {});
  project::writeJob(folder / "job.voluta", result.job);
  const project::Job back = project::readJob(folder / "job.voluta", pipeline::allParameters());
  ASSERT_EQ(back.items.size(), 2u);
  EXPECT_EQ(back.choices.printOrder, layers::PrintOrder::ByLayer);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.choices.item(i).placement.centreMm,
              result.job.choices.item(i).placement.centreMm);
    EXPECT_EQ(back.item(i).part->vertices, result.job.item(i).part->vertices);
    EXPECT_EQ(back.item(i).layers->patches.size(), result.job.item(i).layers->patches.size());
    EXPECT_EQ(back.report.item(i).layers.count, result.job.report.item(i).layers.count);
  }
  ASSERT_TRUE(back.toolPlan);
  EXPECT_TRUE(std::ranges::equal(back.toolPlan->paths, result.job.toolPlan->paths, {},
                                 &plan::ToolPath::item, &plan::ToolPath::item));
  EXPECT_EQ(back.keys(), result.job.keys());
  pipeline::PlanRequest again = twoBoxes(layers::PrintOrder::ByLayer);
  const project::StageKeys wanted = pipeline::stageKeys(again);
  for (std::size_t s = 0; s <= project::indexOf(Stage::Toolpath); ++s)
    EXPECT_EQ(back.keys()[s], wanted[s]) << "not out of date, stage " << s;
}

} // namespace
