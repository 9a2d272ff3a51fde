// Parts with their own tool-paths beside others in one job: order, places, judgement, remedies,
// project and resume.
#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "pipeline/given_paths.h"
#include "pipeline/items/plate_parts.h"
#include "pipeline/judged_part.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/resume.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "project/loaded_part.h"
#include "sliced/slicer_writer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using layers::PrintOrder;
using project::Stage;

constexpr PrintOrder kOrders[] = {PrintOrder::OneAfterAnother, PrintOrder::ByLayer};

// A block of 20 x 18 x 8 mm as a slicer's file.
std::shared_ptr<const project::LoadedPart> slicedBlock() {
  static const auto kBlock = [] {
    PlanRequest request = test::boxRequest({{"rimSupports", "none"}, {"prime", "none"}});
    request.choices.item().mode = "flat";
    request.until = Stage::Toolpath;
    const test::TemporaryFolder folder;
    base::writeFile(
        folder / "block.gcode",
        test::writtenBy(test::Manner::PrusaSlicer, *planPart(request, {}).job.toolPlan).text);
    return project::loadPart((folder / "block.gcode").string(), true, {});
  }();
  return kBlock;
}

// The block and a box of half its size, 40 mm apart; `last`: the block is the second item.
PlanRequest blockAndBox(PrintOrder order, bool last) {
  PlanRequest request;
  request.items = {{"", slicedBlock()}, {"", test::boxPart()}};
  request.choices.items.resize(2);
  request.choices.item(0).automatic = true;
  request.choices.item(1).mode = "flat";
  request.choices.item(1).scale = "0.5";
  request.choices.item(0).placement.centreMm = {-20.0, 0.0};
  request.choices.item(1).placement.centreMm = {20.0, 0.0};
  if (last) {
    std::swap(request.items[0], request.items[1]);
    std::swap(request.choices.items[0], request.choices.items[1]);
  }
  request.choices.printOrder = order;
  request.choices.formats = {"urscript"};
  return request;
}

// The waypoints of an item's beads, in print order.
std::vector<Eigen::Vector3d> waypointsOf(const plan::ToolPlan& plan, int item) {
  std::vector<Eigen::Vector3d> all;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      if (path.item == item && !plan::isWaste(path.kind))
        all.push_back(plan.position[i]);
  return all;
}

std::size_t itemRuns(const plan::ToolPlan& plan) {
  std::size_t runs = 0;
  int last = -1;
  for (const plan::ToolPath& path : plan.paths)
    if (!plan::isWaste(path.kind) && path.item != last) {
      last = path.item;
      ++runs;
    }
  return runs;
}

TEST(GivenItems, KeepTheBeadsOfTheirFileInBothOrders) {
  PlanRequest alone;
  alone.items = {{"", slicedBlock()}};
  alone.choices.item().automatic = true;
  alone.until = Stage::Toolpath;
  const PlanResult one = planPart(alone, {});
  for (const PrintOrder order : kOrders)
    for (const bool last : {false, true}) {
      PlanRequest request = blockAndBox(order, last);
      request.until = Stage::Toolpath;
      const PlanResult both = planPart(request, {});
      ASSERT_TRUE(both.job.toolPlan) << test::reasons(both);
      const plan::ToolPlan& plan = *both.job.toolPlan;
      const auto own = waypointsOf(plan, last ? 1 : 0), was = waypointsOf(*one.job.toolPlan, 0);
      ASSERT_EQ(own.size(), was.size());
      for (std::size_t i = 0; i < own.size(); ++i)
        EXPECT_LT((own[i] - was[i] - Eigen::Vector3d(-20.0, 0.0, 0.0)).norm(), 1e-6);
      const plan::ToolpathStatistics& s = both.job.report.toolpath;
      ASSERT_EQ(s.items.size(), 2u);
      EXPECT_NEAR(s.items[last ? 1 : 0].materialMm3, one.job.report.toolpath.materialMm3, 1e-3);
      EXPECT_NEAR(s.items[0].materialMm3 + s.items[1].materialMm3, s.materialMm3, 1e-6);
      EXPECT_GT(s.items[last ? 0 : 1].paths, 3u);
      EXPECT_EQ(s.waypoints, plan.waypointCount());
      EXPECT_EQ(itemRuns(plan), order == PrintOrder::OneAfterAnother ? 2u
                                : last                               ? 10u
                                                                     : 11u)
          << "five layers of the low box";
      EXPECT_TRUE(std::ranges::is_sorted(plan.paths, {}, &plan::ToolPath::layer));
    }
}

TEST(GivenItems, ThePrimeKeepsClearOfThem) {
  PlanRequest request = blockAndBox(PrintOrder::OneAfterAnother, false);
  request.choices.item(0).placement.centreMm = {0.0, 20.0};
  request.choices.item(1).placement.centreMm = {0.0, 0.0};
  test::giveParameters(request.choices, {{"prime", "skirt"}});
  request.until = Stage::Toolpath;
  const plan::ToolPlan plan = *planPart(request, {}).job.toolPlan;
  ASSERT_EQ(plan.paths.front().kind, plan::PathKind::Skirt);
  Eigen::AlignedBox3d ring, beads;
  for (std::size_t i = 0; i < plan.paths.front().count; ++i)
    ring.extend(plan.position[i]);
  for (const int item : {0, 1})
    for (const Eigen::Vector3d& p : waypointsOf(plan, item))
      beads.extend(p);
  EXPECT_LT(ring.min().x(), beads.min().x());
  EXPECT_GT(ring.max().x(), beads.max().x());
  EXPECT_LT(ring.min().y(), beads.min().y());
  EXPECT_GT(ring.max().y(), beads.max().y());
}

TEST(GivenItems, AreJudgedSavedReopenedAndResumed) {
  for (const PrintOrder order : kOrders) {
    const bool last = order == PrintOrder::ByLayer;
    const PlanRequest request = blockAndBox(order, last);
    const PlanResult both = planPart(request, {});
    EXPECT_TRUE(nothingBlocks(both.job.report)) << test::reasons(both);
    EXPECT_TRUE(both.job.report.replay.passed) << test::reasons(both);
    ASSERT_EQ(both.job.report.replay.items.size(), 2u);
    for (const project::ItemReplayReport& item : both.job.report.replay.items) {
      EXPECT_GE(item.coveredFraction, 0.97);
      EXPECT_NEAR(item.massRatio, 1.0, 0.04);
    }
    EXPECT_EQ(both.job.keys(), stageKeys(request)) << "not out of date";

    const test::TemporaryFolder folder;
    project::writeJob(folder / "job.voluta", both.job);
    const project::Job back = project::readJob(folder / "job.voluta", allParameters());
    EXPECT_EQ(back.keys(), both.job.keys());
    EXPECT_TRUE(std::ranges::equal(back.toolPlan->paths, both.job.toolPlan->paths, {},
                                   &plan::ToolPath::item, &plan::ToolPath::item));
    EXPECT_TRUE(back.item(last ? 1 : 0).loaded->toolPaths);
    if (order == PrintOrder::OneAfterAnother)
      continue;
    ResumeRequest again;
    again.bead = both.job.toolPlan->paths.size() / 2;
    const std::size_t point = resumePointOf(again, resultOf(back), {});
    const ResumeResult rest = resumeJob(back, point, {}, {});
    EXPECT_TRUE(rest.plan.job.report.replay.passed) << test::reasons(rest.plan);
  }
}

TEST(GivenItems, SeveralFilesAreOneJob) {
  PlanRequest request = blockAndBox(PrintOrder::ByLayer, false);
  request.items[1] = request.items[0];
  request.choices.item(1) = request.choices.item(0);
  request.choices.item(1).placement.centreMm = {20.0, 0.0};
  request.until = Stage::Motion;
  const PlanResult both = planPart(request, {});
  EXPECT_TRUE(nothingBlocks(both.job.report)) << test::reasons(both);
  EXPECT_EQ(waypointsOf(*both.job.toolPlan, 0).size(), waypointsOf(*both.job.toolPlan, 1).size());
  EXPECT_FALSE(both.job.toolPlan->primes());
  EXPECT_TRUE(both.job.trajectory);
}

TEST(GivenItems, OthersMayLeaveTheirWayToModeAuto) {
  PlanRequest request = blockAndBox(PrintOrder::OneAfterAnother, false);
  request.choices.item(1).automatic = true;
  request.until = Stage::Toolpath;
  const PlanResult both = planPart(request, {});
  EXPECT_TRUE(both.job.report.item(0).tried.empty());
  EXPECT_FALSE(both.job.report.item(1).tried.empty());
  EXPECT_TRUE(both.job.toolPlan);
}

TEST(GivenItems, AGroundOfItsOwnIsPrintedAlone) {
  PlanRequest request = blockAndBox(PrintOrder::OneAfterAnother, false);
  request.choices.item(0).parameters["pathsOn"] = "cylinder";
  try {
    planPart(request, {});
    ADD_FAILURE() << "it is planned";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ErrorCode::Usage);
    EXPECT_NE(std::string(error.what()).find("printed alone"), std::string::npos) << error.what();
  }
}

// A build file that is placed in the work frame.
std::shared_ptr<const project::LoadedPart> inWorkFrame(const Eigen::Vector3d& centre) {
  auto part = std::make_shared<project::LoadedPart>(*slicedBlock());
  const auto moved = [&](const geometry::TriangleMesh& mesh) {
    auto copy = std::make_shared<geometry::TriangleMesh>(mesh);
    for (Eigen::Vector3d& v : copy->vertices)
      v += centre;
    return copy;
  };
  auto paths = std::make_shared<plan::ToolPlan>(*part->toolPaths);
  for (Eigen::Vector3d& p : paths->position)
    p += centre;
  part->source = part->mesh = moved(*part->mesh);
  part->toolPaths = std::move(paths);
  part->inWorkFrame = true;
  part->hash = project::hashOf(*part);
  return part;
}

TEST(GivenItems, APlaceInTheWorkFrameHoldsForAPartAlone) {
  PlanRequest alone;
  alone.items = {{"", inWorkFrame({30.0, -12.0, 0.0})}};
  alone.choices.item().automatic = true;
  alone.until = Stage::Load;
  const auto middleX = [](const PlanResult& result) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : result.job.item(0).part->vertices)
      box.extend(v);
    return box.center().x();
  };
  const double kept = middleX(planPart(alone, {}));
  EXPECT_GT(std::abs(kept), 10.0);
  PlanRequest both = blockAndBox(PrintOrder::OneAfterAnother, false);
  both.items[0] = alone.items[0];
  both.choices.item(0).placement.centreMm = {0.0, 0.0};
  both.choices.item(1).placement.centreMm = {50.0, 0.0};
  both.until = Stage::Load;
  const PlanResult beside = planPart(both, {});
  EXPECT_NEAR(middleX(beside), 0.0, 1e-6) << "the middle of the plate, as any item without a place";
  EXPECT_EQ(beside.job.keys()[0], stageKeys(both)[0]);
  // Arranged, it is where it was put and not where its file has it.
  const PlanRequest arranged = withArrangedParts(both, {});
  EXPECT_NEAR(middleX(planPart(arranged, {})), arranged.choices.item(0).placement.centreMm.x(),
              1e-6);
}

// A slicer puts its skirt several millimetres beside the part.
TEST(GivenItems, AreArrangedWithTheirSkirts) {
  PlanRequest request = blockAndBox(PrintOrder::ByLayer, false);
  auto part = std::make_shared<project::LoadedPart>(*slicedBlock());
  auto paths = std::make_shared<plan::ToolPlan>(*part->toolPaths);
  const Eigen::Vector3d corner = part->mesh->vertices.front();
  plan::ToolPath skirt{.first = paths->waypointCount(), .kind = plan::PathKind::Skirt};
  for (const double x : {-40.0, 40.0}) {
    paths->position.emplace_back(corner.x() + x, corner.y(), 0.8);
    paths->direction.emplace_back(0.0, 0.0, 1.0);
    paths->widthMm.push_back(1.2F);
    paths->heightMm.push_back(0.8F);
    paths->speedMmPerS.push_back(20.0F);
    ++skirt.count;
  }
  paths->paths.push_back(skirt);
  part->toolPaths = std::move(paths);
  part->hash = project::hashOf(*part);
  request.items[0].loaded = std::move(part);
  request.until = Stage::Toolpath;
  const PlanResult planned = planPart(withArrangedParts(request, {}), {});
  ASSERT_TRUE(planned.job.toolPlan) << test::reasons(planned);
  Eigen::AlignedBox2d beside, skirts;
  for (const Eigen::Vector3d& p : waypointsOf(*planned.job.toolPlan, 1))
    beside.extend(p.head<2>());
  for (const plan::ToolPath& path : planned.job.toolPlan->paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      if (path.item == 0 && plan::isWaste(path.kind))
        skirts.extend(planned.job.toolPlan->position[i].head<2>());
  EXPECT_GT(skirts.sizes().x(), 79.0);
  EXPECT_GT(skirts.exteriorDistance(beside), 3.0);
}

// The process corrects the sizes of planned layers only.
TEST(GivenItems, AreJudgedByTheSizeOfTheirBeads) {
  std::string process = base::readFile(base::resourceFolder() / "processes" / "fdm-1.0.json");
  const std::size_t at = process.find("\"head\"");
  ASSERT_NE(at, std::string::npos);
  process.insert(at, "\"scaleX\": 1.1, ");
  PlanRequest request = blockAndBox(PrintOrder::OneAfterAnother, false);
  request.choices.tool().process = process;
  request.until = Stage::Decompose;
  const PlanResult planned = planPart(request, {});
  const auto boundsOf = [&](const geometry::TriangleMesh& all, double sign) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : all.vertices)
      if (sign * v.x() > 0.0)
        box.extend(v);
    return box;
  };
  const auto printed = project::printedOf(planned.job);
  const auto judged = judgedPart(planned.job, planned.resolved());
  const double block = boundsOf(*printed, -1.0).sizes().x(),
               box = boundsOf(*printed, 1.0).sizes().x();
  EXPECT_NEAR(boundsOf(*judged, -1.0).sizes().x(), block, 1e-9);
  EXPECT_NEAR(boundsOf(*judged, 1.0).sizes().x(), 1.1 * box, 1e-6);
}

TEST(GivenItems, FindingsHaveTheRemediesOfTheirItem) {
  using enum plan::FindingKind;
  plan::Findings findings(3, plan::makeFinding(Mass, {{"share", base::percent(112.0)}}));
  findings[0].item = 0;
  findings[1].item = 1;
  const auto kinds = [&](const std::vector<bool>& isGiven) {
    std::vector<plan::FindingKind> all;
    for (const plan::Finding& finding : withRemediesForGiven(findings, isGiven))
      all.push_back(finding.kind);
    return all;
  };
  EXPECT_EQ(kinds({true, false}), (std::vector{GivenMass, Mass, Mass}));
  EXPECT_EQ(kinds({false, true}), (std::vector{Mass, GivenMass, Mass}));
  EXPECT_EQ(kinds({true, true}), (std::vector{GivenMass, GivenMass, GivenMass}));
  EXPECT_EQ(kinds({false, false}), (std::vector{Mass, Mass, Mass}));
}

} // namespace
} // namespace voluta::pipeline
