// Parameters supports and orient in whole plans: a part that growth alone cannot print completely.
#include "curved/decomposition.h"
#include "helpers/given_parameters.h"
#include "layers/layer_stack.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/tool_plan.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/mesh_measures.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "plan/finding_kinds.h"
#include "project/job.h"
#include "voxel/voxel_object.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;

namespace {

// Two posts, a beam, and a tooth from the beam down between the posts, inside the front of all
// voxels before it.
std::shared_ptr<const LoadedPart> toothPart(bool asCells) {
  voxel::VoxelObject object;
  object.size = {24, 6, 19};
  for (int k = 0; k < 19; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 24; ++i)
        object.solid.push_back(i < 4 || i >= 20 || k >= 16 ||
                               ((i == 11 || i == 12) && (j == 2 || j == 3) && k >= 8));
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 24; ++i)
      if (i < 4 || i >= 20)
        object.platform.push_back({i, j});
  if (asCells)
    return loadedFrom("tooth.txt", std::make_shared<voxel::VoxelObject>(object), true, {});
  return loadedFrom("tooth.stl", std::make_shared<geometry::TriangleMesh>(voxel::surfaceOf(object)),
                    {}, true, {});
}

// With a front that loses the tooth unless `parameters` change that.
PlanResult planned(const std::map<std::string, std::string>& parameters, Stage until,
                   bool asCells = false) {
  PlanRequest request;
  request.item().loaded = toothPart(asCells);
  request.until = until;
  test::giveParameters(request.choices, parameters);
  request.choices.item().parameters["voxelMm"] = "1";
  request.choices.item().parameters.insert({{"supports", "none"}, {"frontShape", "flat"}});
  return planPart(request, base::RunContext(base::CancelToken{}, 2));
}

std::size_t countOf(const Report& report, const std::string& kind) {
  return static_cast<std::size_t>(
      std::count_if(report.findings.begin(), report.findings.end(),
                    [&](const auto& f) { return voluta::plan::reportId(f) == kind; }));
}

TEST(Lossless, WithoutSupportsTheToothIsMissed) {
  const PlanResult plan = planned({}, Stage::Decompose);
  const DecompositionReport& r = plan.job.report.item().decomposition;
  EXPECT_GT(r.missedVoxels, 0u);
  EXPECT_EQ(r.missedAfterSupports, r.missedVoxels);
  EXPECT_EQ(r.supportVolumeMm3, 0.0);
  EXPECT_FALSE(nothingBlocks(plan.job.report));
  EXPECT_TRUE(plan.job.item().decomposition()->support.empty());
}

TEST(Lossless, SupportsCarryTheToothOnAColumn) {
  const PlanResult plan = planned({{"supports", "auto"}}, Stage::Toolpath);
  const Report& report = plan.job.report;
  const DecompositionReport& r = report.item().decomposition;
  EXPECT_GT(r.missedVoxels, 0u); // before
  EXPECT_EQ(r.missedVoxels, r.shadowedVoxels + r.unreachedVoxels);
  EXPECT_EQ(r.missedAfterSupports, 0u);
  EXPECT_NEAR(r.supportVolumeMm3, 8.0, 1e-9);
  EXPECT_TRUE(nothingBlocks(report));
  EXPECT_EQ(countOf(report, "supportColumn"), 1u);
  EXPECT_EQ(countOf(report, "unsupportedPatches"), 0u);

  const curved::Decomposition& d = *plan.job.item().decomposition();
  EXPECT_EQ(d.supportVoxels, 8u);
  EXPECT_EQ(r.voxels, d.voxels);
  EXPECT_EQ(static_cast<std::size_t>(std::count(d.support.begin(), d.support.end(), 1)), 8u);
  for (std::size_t c = 0; c < d.rank.size(); ++c)
    EXPECT_TRUE(d.support[c] == 0 || d.rank[c] > 0);

  // Separate from the part all the way to the beads.
  std::size_t patches = 0, paths = 0;
  for (const layers::Patch& patch : plan.job.item().layers->patches)
    patches += patch.group == layers::kSupportGroup;
  for (const plan::ToolPath& path : plan.job.toolPlan->paths) {
    if (plan::isWaste(path.kind))
      continue;
    EXPECT_EQ(path.kind == plan::PathKind::Support, path.group == layers::kSupportGroup);
    paths += path.kind == plan::PathKind::Support;
  }
  EXPECT_EQ(patches, 10u);
  EXPECT_EQ(paths, 10u);
  EXPECT_NEAR(report.item().layers.areaMm2 * report.item().layers.thicknessMeanMm,
              geometry::volume(*plan.job.item().part),
              0.02 * geometry::volume(*plan.job.item().part));
}

TEST(Lossless, ASupportedPlanIsKeptInItsProject) {
  const PlanResult plan = planned({{"supports", "auto"}}, Stage::Layers);
  const test::TemporaryFolder folder;
  writeJob(folder / "job.voluta", plan.job);
  const Job job = readJob(folder / "job.voluta", allParameters());
  EXPECT_EQ(job.item().decomposition()->support, plan.job.item().decomposition()->support);
  EXPECT_EQ(job.item().decomposition()->supportVoxels, 8u);
  EXPECT_EQ(job.item().layers->patches.back().group, plan.job.item().layers->patches.back().group);
  EXPECT_EQ(job.report.item().decomposition.missedAfterSupports, 0u);
}

TEST(Lossless, ByItselfModeCurvedMissesNothing) {
  PlanRequest request;
  request.item().loaded = toothPart(false);
  request.until = Stage::Decompose;
  request.choices.item().parameters["voxelMm"] = "1";
  const PlanResult plan = planPart(request, {});
  EXPECT_EQ(plan.job.report.item().decomposition.missedAfterSupports, 0u);
  EXPECT_TRUE(nothingBlocks(plan.job.report));
}

// A block over a wide plate on a stem at its side: a platform as wide as the stem's foot leaves the
// head room below it.
TEST(Lossless, VolumeThatAPedestalWouldSaveIsNamed) {
  voxel::VoxelObject object;
  object.size = {30, 8, 16};
  for (int k = 0; k < 16; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 30; ++i)
        object.solid.push_back(i < 6 || k >= 12 || (i >= 24 && k >= 4));
  PlanRequest request;
  request.item().loaded = loadedFrom(
      "hook.stl", std::make_shared<geometry::TriangleMesh>(voxel::surfaceOf(object)), {}, true, {});
  request.until = Stage::Decompose;
  test::giveParameters(request.choices, {{"voxelMm", "1"}, {"frontShape", "flat"}});
  request.choices.item().platform = Platform("disc:150");
  const PlanResult wide = planPart(request, {});
  ASSERT_GT(wide.job.report.item().decomposition.missedVoxels, 0u);
  ASSERT_EQ(countOf(wide.job.report, "pedestal"), 1u);
  const auto reported = std::ranges::find(wide.job.report.findings,
                                          plan::FindingKind::PedestalGains, &plan::Finding::kind);
  EXPECT_EQ(reported->count, wide.job.report.item().decomposition.missedVoxels);

  // As in the finding: without columns, on a pedestal.
  request.choices.item().platform = Platform("fit:0");
  request.choices.item().parameters["supports"] = "none";
  const PlanResult fit = planPart(request, {});
  const std::size_t missed = fit.job.report.item().decomposition.missedVoxels;
  EXPECT_NE(plan::englishReason(*reported).find(" on this plate, " + std::to_string(missed)),
            std::string::npos)
      << plan::englishReason(*reported);
  EXPECT_EQ(countOf(fit.job.report, "pedestal"), 0u);
}

TEST(Lossless, TurnedItNeedsNoSupport) {
  for (const bool asCells : {false, true}) {
    const PlanResult plan = planned({{"orient", "fewestMissed"}}, Stage::Decompose, asCells);
    EXPECT_EQ(plan.job.report.item().decomposition.missedVoxels, 0u) << asCells;
    EXPECT_EQ(countOf(plan.job.report, "turned"), 1u) << asCells;
    EXPECT_EQ(countOf(plan.job.report, "newCells"), 0u) << asCells;
    EXPECT_TRUE(nothingBlocks(plan.job.report)) << asCells;
    EXPECT_LT(test::centreOfMass(*plan.job.item().part).z(), 9.5) << "the beam is not below";
    EXPECT_NEAR(plan.job.report.item().model.boundsMm.min().z(), 0.0, 1e-9);
  }
}

TEST(Lossless, LeastRiskyNamesTheAreaBeforeAndAfter) {
  const PlanResult plan = planned({{"orient", "leastRisky"}}, Stage::Load);
  ASSERT_EQ(countOf(plan.job.report, "turned"), 1u);
  const plan::Finding& f = plan.job.report.findings.back();
  EXPECT_FALSE(f.blocking);
  EXPECT_NE(voluta::plan::englishReason(f).find("mm2 instead of"), std::string::npos)
      << voluta::plan::englishReason(f);
}

TEST(Lossless, MinResidualAreaStatesBothAreas) {
  PlanRequest request = test::boxRequest({{"orient", "leastResidual"}});
  request.choices.item().placement.rotation =
      Eigen::AngleAxisd(base::degreesToRadians(30.0), Eigen::Vector3d::UnitZ());
  request.until = Stage::Load;
  const PlanResult plan = planPart(request, {});
  ASSERT_EQ(countOf(plan.job.report, "turned"), 1u);
  const std::string text = plan::englishReason(plan.job.report.findings.back());
  EXPECT_NE(text.find("turned by 30"), std::string::npos) << text;
  EXPECT_NE(text.find("residual area on XY 0 mm2 instead of"), std::string::npos) << text;
}

TEST(Lossless, LeastAfterCutsNamesTheOverhangOfThePieces) {
  const PlanResult plan = planned({{"orient", "leastAfterCuts"}}, Stage::Load);
  ASSERT_EQ(countOf(plan.job.report, "turned"), 1u);
  const std::string text = plan::englishReason(plan.job.report.findings.back());
  EXPECT_NE(text.find("estimated overhang after cutting 0 mm2 (pieces: 1)"), std::string::npos)
      << text;
}

// In mode planar the sentence has the overhang of the plan's own cuts, not the estimate.
TEST(Lossless, LeastAfterCutsNamesTheOverhangOfThePlansCuts) {
  PlanRequest request;
  request.item().loaded = toothPart(false);
  request.until = Stage::Decompose;
  request.choices.item().mode = "planar";
  request.choices.item().automatic = false;
  test::giveParameters(request.choices, {{"orient", "leastAfterCuts"}, {"planarScheme", "greedy"}});
  const PlanResult plan = planPart(request, {});
  const auto turned = std::ranges::find(plan.job.report.findings,
                                        plan::FindingKind::TurnedAfterCuts, &plan::Finding::kind);
  ASSERT_NE(turned, plan.job.report.findings.end());
  const std::string text = plan::englishReason(*turned),
                    left = fmt::format("overhang after cutting {:.0f} mm2 (pieces: {})",
                                       plan.job.report.item().decomposition.riskyAreaMm2,
                                       plan.job.report.item().decomposition.pieces);
  EXPECT_NE(text.find(left), std::string::npos) << text;
}

TEST(Lossless, OddValuesAreNamed) {
  for (const char* key : {"supports", "orient"}) {
    Choices choices;
    EXPECT_THROW(setParameters(choices, {std::string(key) + "=yes"}), base::Error);
  }
}

} // namespace
