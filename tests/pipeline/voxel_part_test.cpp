// Parts given as cells, and errors for unsuitable cells.
#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "curved/decomposition.h"
#include "geometry/measures.h"
#include "helpers/loaded_box.h"
#include "helpers/temporary_folder.h"
#include "modes/mode_stages.h"
#include "modes/part_voxels.h"
#include "pipeline/checked_program.h"
#include "pipeline/resolved.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "voxel/voxel_text.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;

namespace {

using ::testing::HasSubstr;
constexpr double kQuarter = 1.5707963267948966;

std::string sample(const std::string& name) {
  return std::string(VOLUTA_SOURCE_DIR) + "/resources/samples/" + name;
}

std::shared_ptr<const LoadedPart> textPart(const std::string& text) {
  return loadedFrom(
      "t.txt", std::make_shared<voxel::VoxelObject>(voxel::readVoxelText(text, "t.txt")), true, {});
}

// An L: three cells up, two along, on a platform of five.
std::shared_ptr<const LoadedPart> ell() {
  static const auto kPart = textPart("01000\n01000\n01100\n-----\n");
  return kPart;
}

PlanRequest requestFor(const std::shared_ptr<const LoadedPart>& part, Stage until) {
  PlanRequest request;
  request.item().loaded = part;
  request.until = until;
  return request;
}

std::shared_ptr<const LoadStage> placedEll(const Choices& choices) {
  return loadStage(*ell(), resolve(choices));
}

Eigen::AlignedBox2d boxOf(const std::vector<Eigen::Vector2d>& polygon) {
  Eigen::AlignedBox2d box;
  for (const auto& p : polygon)
    box.extend(p);
  return box;
}

void expectBox(const std::vector<Eigen::Vector2d>& polygon, double x0, double y0, double x1,
               double y1) {
  const Eigen::AlignedBox2d box = boxOf(polygon);
  ASSERT_FALSE(box.isEmpty());
  EXPECT_NEAR(box.min().x(), x0, 1e-9);
  EXPECT_NEAR(box.min().y(), y0, 1e-9);
  EXPECT_NEAR(box.max().x(), x1, 1e-9);
  EXPECT_NEAR(box.max().y(), y1, 1e-9);
}

// A process of the user's own with layers as high.
std::string ofHeight(double mm) {
  auto json = nlohmann::ordered_json::parse(
      base::readFile(base::resourceFolder() / "processes" / "fdm-1.0.json"));
  json["id"] = "high";
  json["layerHeightMm"] = {{"default", mm}, {"min", 0.5 * mm}, {"max", 1.25 * mm}};
  json["beadWidthMm"] = {{"default", 1.5 * mm}, {"min", 1.25 * mm}, {"max", 2.5 * mm}};
  json["maxFlowMm3PerS"] = 1000.0;
  return json.dump();
}

std::string errorOf(const PlanRequest& request) {
  try {
    planPart(request, {});
  } catch (const base::Error& e) {
    return e.what();
  }
  return {};
}

TEST(VoxelPart, SamplesGoTheRoadWithNothingMissed) {
  for (const auto& [name, voxels] :
       {std::pair("fork.txt", 14040u), std::pair("mushroom.txt", 17818u)}) {
    PlanRequest request;
    request.item().part = sample(name);
    request.until = Stage::Layers;
    const PlanResult result = planPart(request, {});
    const Report& report = result.job.report;
    EXPECT_EQ(report.item().decomposition.voxels, voxels);
    EXPECT_EQ(report.item().decomposition.missedVoxels, 0u);
    EXPECT_DOUBLE_EQ(report.item().decomposition.voxelMm, 0.8);
    EXPECT_TRUE(report.item().model.watertight);
    EXPECT_NEAR(report.item().model.volumeMm3, voxels * 0.512, 1e-6);
    EXPECT_GT(report.item().layers.count, 5);
    // Exactly the object's cells, not those that the voxeliser would have made of its surface.
    const auto& rank = result.job.item().decomposition()->rank;
    EXPECT_EQ(static_cast<std::size_t>(
                  std::count_if(rank.begin(), rank.end(), [](int r) { return r > 0; })),
              voxels);
  }
}

TEST(VoxelPart, SamplesBecomeProgramsWithoutAnyChoice) {
  for (const char* name : {"fork.txt", "mushroom.txt"}) {
    PlanRequest request;
    request.item().part = sample(name);
    request.choices.item().automatic = true;
    request.choices.formats = {"urscript"};
    const PlanResult result = planPart(request, {});
    ASSERT_EQ(result.checked.size(), 1u) << name;
    EXPECT_TRUE(result.checked.front()->verdict.passed) << name;
    EXPECT_EQ(result.job.report.item().decomposition.mode, "curved") << name << " overhangs";
  }
}

TEST(VoxelPart, UsesItsOwnPlatform) {
  const auto placed = placedEll({});
  ASSERT_TRUE(placed->voxels);
  EXPECT_EQ(placed->voxels->count, 4u);
  EXPECT_EQ(placed->voxels->plateLayer(), 1);
  EXPECT_DOUBLE_EQ(placed->voxels->grid.pitch, 0.8);
  EXPECT_TRUE(placed->findings.empty());
  // The L is two cells wide from the platform's second cell on, and centred.
  expectBox(placed->platform, -2 * 0.8, -0.4, 3 * 0.8, 0.4);
  const Eigen::AlignedBox3d box = geometry::bounds(*placed->part);
  EXPECT_NEAR((box.min() - Eigen::Vector3d(-0.8, -0.4, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((box.max() - Eigen::Vector3d(0.8, 0.4, 2.4)).norm(), 0.0, 1e-9);

  const PlanResult fit = planPart(requestFor(ell(), Stage::Decompose), {});
  expectBox(fit.job.item().platform.polygon, -1.6, -0.4, 2.4, 0.4);
  PlanRequest wide = requestFor(ell(), Stage::Decompose);
  wide.choices.item().platform = project::Platform("fit:1");
  const Eigen::AlignedBox2d widened = boxOf(planPart(wide, {}).job.item().platform.polygon);
  EXPECT_LE(widened.min().x(), -2.6 + 1e-9);
  EXPECT_GE(widened.max().y(), 1.4 - 1e-9);
  wide.choices.item().platform = project::Platform("rect:10x4");
  expectBox(planPart(wide, {}).job.item().platform.polygon, -5, -2, 5, 2);
}

TEST(VoxelPart, ScaleAndVoxelWidthBothWidenTheCells) {
  Choices choices;
  choices.item().scale = "2";
  choices.item().parameters["voxelMm"] = "0.5";
  const auto placed = placedEll(choices);
  EXPECT_DOUBLE_EQ(placed->scale, 2.0);
  EXPECT_DOUBLE_EQ(placed->voxels->grid.pitch, 1.0);
  EXPECT_NEAR(geometry::volume(*placed->part), 4.0, 1e-9);
  expectBox(placed->platform, -2, -0.5, 3, 0.5);
}

TEST(VoxelPart, IsAsLargeWithAnyProcess) {
  Choices choices;
  choices.tool().process = ofHeight(3.2);
  ASSERT_DOUBLE_EQ(parameterValues(choices).number("voxelMm"), 3.2) << "for meshes";
  EXPECT_DOUBLE_EQ(unitMm(*ell(), choices), 0.8);
  EXPECT_NEAR(geometry::volume(*placedEll(choices)->part), 4 * 0.8 * 0.8 * 0.8, 1e-9);
  choices.item().parameters["voxelMm"] = "2";
  EXPECT_DOUBLE_EQ(unitMm(*ell(), choices), 2.0) << "the user's own";
}

TEST(VoxelPart, QuarterTurnsAndMovesKeepItsCells) {
  Choices choices;
  choices.item().placement.rotation = Eigen::AngleAxisd(kQuarter, Eigen::Vector3d::UnitZ());
  choices.item().placement.centreMm = {10.0, 20.0};
  const auto turned = placedEll(choices);
  EXPECT_TRUE(turned->findings.empty());
  EXPECT_EQ(turned->voxels->grid.size, Eigen::Vector3i(3, 4, 5));
  expectBox(turned->platform, 10 - 0.4, 20 - 1.6, 10 + 0.4, 20 + 2.4);

  choices.item().placement.rotation = Eigen::AngleAxisd(kQuarter, Eigen::Vector3d::UnitY());
  choices.item().placement.liftMm = 1.6;
  const auto tipped = placedEll(choices);
  EXPECT_TRUE(tipped->findings.empty());
  EXPECT_EQ(tipped->voxels->count, 4u);
  EXPECT_EQ(tipped->voxels->plateLayer(), -1);
  EXPECT_TRUE(tipped->platform.empty()) << "its platform stands upright now";
  // Cells and surface are in the same place.
  const Eigen::AlignedBox3d box = geometry::bounds(*tipped->part);
  EXPECT_NEAR((tipped->voxels->grid.origin + Eigen::Vector3d::Constant(0.8) - box.min()).norm(),
              0.0, 1e-9);
}

TEST(VoxelPart, OtherRotationsAndLiftsMakeNewCellsWithAFinding) {
  Choices choices;
  choices.item().placement.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ());
  const auto turned = placedEll(choices);
  ASSERT_EQ(turned->findings.size(), 1u);
  EXPECT_EQ(voluta::plan::reportId(turned->findings[0]), "newCells");
  EXPECT_THAT(voluta::plan::englishReason(turned->findings[0]), HasSubstr("multiple of 90"));
  EXPECT_FALSE(turned->findings[0].blocking);
  EXPECT_GT(turned->voxels->count, 4u);
  EXPECT_DOUBLE_EQ(turned->voxels->grid.pitch, 0.8);
  EXPECT_FALSE(turned->platform.empty()) << "it still lies flat";

  choices = {};
  choices.item().placement.liftMm = 0.3;
  const auto lifted = placedEll(choices);
  ASSERT_EQ(lifted->findings.size(), 1u);
  EXPECT_THAT(voluta::plan::englishReason(lifted->findings[0]), HasSubstr("fraction of a voxel"));

  choices.item().placement.liftMm = 0.0;
  choices.item().placement.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ());
  PlanRequest request = requestFor(ell(), Stage::Decompose);
  request.choices = choices;
  const Report report = planPart(request, {}).job.report;
  EXPECT_EQ(std::count_if(report.findings.begin(), report.findings.end(),
                          [](const auto& f) { return voluta::plan::reportId(f) == "newCells"; }),
            1);
}

TEST(VoxelPart, KeysKnowItsCellsItsPlatformAndTheirWidth) {
  const auto keyOf = [](const std::shared_ptr<const LoadedPart>& part, const char* voxelMm) {
    PlanRequest request = requestFor(part, Stage::Load);
    request.choices.item().parameters["voxelMm"] = voxelMm;
    return stageKeys(request)[0];
  };
  EXPECT_EQ(keyOf(ell(), "0.8"), keyOf(textPart("01000\n01000\n01100\n-----\n"), "0.8"));
  EXPECT_NE(keyOf(ell(), "0.8"), keyOf(ell(), "0.7"));
  EXPECT_NE(keyOf(ell(), "0.8"), keyOf(textPart("01000\n01000\n01100\n0----\n"), "0.8"));
  EXPECT_NE(keyOf(ell(), "0.8"), keyOf(textPart("01000\n01000\n00100\n-----\n"), "0.8"));
  const auto mesh = test::loadedBox({0, 0, 0}, {4, 4, 4});
  EXPECT_EQ(keyOf(mesh, "0.8"), keyOf(mesh, "0.7")) << "a mesh does not care until it is cut";
}

TEST(VoxelPart, ProjectsKeepItsCells) {
  StageCache cache;
  const PlanResult planned = planPart(requestFor(ell(), Stage::Decompose), {}, &cache);
  const test::TemporaryFolder folder;
  writeJob(folder / "cells.voluta", planned.job);
  const Job job = readJob(folder / "cells.voluta", allParameters());
  ASSERT_TRUE(job.item().loaded->cells);
  EXPECT_EQ(job.item().loaded->cells->solid, ell()->cells->solid);
  EXPECT_EQ(job.item().loaded->cells->platform, ell()->cells->platform);
  EXPECT_EQ(job.item().loaded->hash, ell()->hash);

  StageCache reopened;
  seedCache(reopened, job);
  PlanRequest again = requestFor(job.item().loaded, Stage::Decompose);
  EXPECT_EQ(stageKeys(again), stageKeys(requestFor(ell(), Stage::Decompose)));
  again.choices.item().growth =
      curved::GrowthScheme("greedy"); // made anew: from the object's cells, not from its surface
  const PlanResult other = planPart(again, {}, &reopened);
  EXPECT_EQ(other.job.report.item().decomposition.voxels, 4u);
  expectBox(other.job.item().platform.polygon, -1.6, -0.4, 2.4, 0.4);
}

TEST(VoxelPart, BadFilesAreOneLineWithTheirPlace) {
  const test::TemporaryFolder folder;
  PlanRequest request;
  request.item().part = (folder / "bad.txt").string();
  base::writeFile(request.item().part, "0110\n01z0\n----\n");
  const std::string line = errorOf(request);
  EXPECT_THAT(line, HasSubstr(request.item().part + ", line 2, column 3"));
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

TEST(BadVoxels, PartThatDoesNotTouchThePlatformIsRefused) {
  PlanRequest request = requestFor(ell(), Stage::Decompose);
  request.choices.item().placement.liftMm = 8.0;
  EXPECT_THAT(errorOf(request), HasSubstr("does not touch the platform"));
  request.choices.item().platform = project::Platform("disc:5");
  EXPECT_THAT(errorOf(request), HasSubstr("does not touch the platform"));

  request = requestFor(test::loadedBox({0, 0, 0}, {4, 4, 4}), Stage::Decompose);
  request.choices.item().placement.liftMm = 3.0;
  EXPECT_THAT(errorOf(request), HasSubstr("does not touch the plate"));
  request.choices.item().placement.liftMm = 0.0;
  request.choices.item().placement.centreMm = {100.0, 0.0};
  request.choices.item().platform = project::Platform("disc:20");
  EXPECT_THAT(errorOf(request), HasSubstr("does not touch the platform"));
}

TEST(BadVoxels, AWidthThatNeedsMoreMemoryThanThereIsNamesOneThatFits) {
  PlanRequest request = requestFor(
      loadedFrom("big.stl",
                 std::make_shared<geometry::TriangleMesh>(test::box({0, 0, 0}, {150, 150, 1900})),
                 {}, true, {}),
      Stage::Decompose);
  request.choices.item().parameters["voxelMm"] = "0.1";
  const std::string line = errorOf(request);
  EXPECT_THAT(line, HasSubstr("voxelMm"));
  EXPECT_THAT(line, HasSubstr("of memory"));
  EXPECT_THAT(line, HasSubstr("use at least "));
}

TEST(BadVoxels, ThinWallsAreNamedWithASufficientWidth) {
  geometry::TriangleMesh mesh = test::box({0, 0, 0}, {6, 6, 3});
  test::append(mesh, test::box({2, 2, 3}, {2.37, 5, 9}));
  const plan::Findings found = thinWallFindings(mesh, 0.8, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(plan::stageOf(found[0]), plan::Stage::Decompose);
  EXPECT_EQ(voluta::plan::reportId(found[0]), "thinWalls");
  EXPECT_FALSE(found[0].blocking);
  ASSERT_TRUE(found[0].where);
  EXPECT_NEAR(found[0].where->x(), 2.2, 0.21);
  EXPECT_THAT(voluta::plan::englishReason(found[0]), HasSubstr("0.37 mm thick"));
  EXPECT_EQ(voluta::plan::englishRemedy(found[0]), "use a voxel width of at most 0.37 mm");
  EXPECT_TRUE(thinWallFindings(mesh, 0.37, {}).empty()) << "the remedy cures it";

  PlanRequest request =
      requestFor(loadedFrom("w.stl", std::make_shared<geometry::TriangleMesh>(mesh), {}, false, {}),
                 Stage::Decompose);
  const Report report = planPart(request, {}).job.report;
  EXPECT_EQ(std::count_if(report.findings.begin(), report.findings.end(),
                          [](const auto& f) { return voluta::plan::reportId(f) == "thinWalls"; }),
            1);

  geometry::TriangleMesh many = test::box({0, 0, 0}, {1, 1, 1});
  for (int i = 0; i < 9; ++i)
    test::append(many, test::box({20.0 * i, 0, 0}, {20.0 * i + 0.05 * (i + 1), 3, 3}));
  const plan::Findings some = thinWallFindings(many, 0.8, {});
  ASSERT_EQ(some.size(), 6u);
  EXPECT_THAT(voluta::plan::englishReason(some[5]), HasSubstr("4 smaller places"));
  EXPECT_THAT(plan::englishRemedy(thinWallFindings(test::box({0, 0, 0}, {0.05, 3, 3}), 0.8, {})[0]),
              HasSubstr("thicken the wall"));
}

} // namespace
