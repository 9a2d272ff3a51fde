// A surface that encloses nothing is planned on the user's word only.
#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "helpers/bow_tie.h"
#include "helpers/given_parameters.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "pipeline/open_part.h"
#include "pipeline/remedies.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

using namespace voluta;
using pipeline::PlanRequest;
using pipeline::PlanResult;
using plan::FindingKind;
using project::Stage;

namespace {

// A box without its top, and one of double-sided walls only.
std::shared_ptr<const project::LoadedPart> cup(bool repair = true) {
  geometry::TriangleMesh m = test::box({0, 0, 0}, {30, 30, 20});
  m.triangles.erase(m.triangles.begin() + 2, m.triangles.begin() + 4);
  return project::loadedFrom("cup.stl", std::make_shared<geometry::TriangleMesh>(std::move(m)), {},
                             repair, {});
}
std::shared_ptr<const project::LoadedPart> sheet() {
  geometry::TriangleMesh m;
  m.vertices = {{0, 0, 0}, {30, 0, 0}, {30, 0, 20}, {0, 0, 20}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  return project::loadedFrom("sheet.stl", std::make_shared<geometry::TriangleMesh>(std::move(m)),
                             {}, true, {});
}

PlanResult planned(std::shared_ptr<const project::LoadedPart> part, const std::string& choice,
                   Stage until = Stage::Load) {
  PlanRequest request;
  request.item().loaded = std::move(part);
  request.choices.item().mode = "flat";
  test::giveParameters(request.choices, {{"openSurfaces", choice}});
  request.until = until;
  return pipeline::planPart(request, {});
}

const plan::Finding& first(const PlanResult& result) {
  EXPECT_FALSE(result.job.report.findings.empty());
  return result.job.report.findings.front();
}

TEST(OpenPart, IsRefusedFirstOfAll) {
  for (const auto& [part, kind] :
       {std::pair(cup(), FindingKind::OpenRims), std::pair(sheet(), FindingKind::SheetModel)}) {
    const PlanResult result = planned(part, "refuse", Stage::Replay);
    EXPECT_EQ(result.job.report.findings.size(), 1u);
    EXPECT_EQ(first(result).kind, kind);
    EXPECT_TRUE(first(result).blocking);
    EXPECT_EQ(result.job.reached, Stage::Load) << "nothing is planned in silence";
  }
}

TEST(OpenPart, ModeAutoRefusesItOnceForAllWays) {
  PlanRequest request;
  request.item().loaded = cup();
  request.choices.item().automatic = true;
  test::giveParameters(request.choices, {{"openSurfaces", "refuse"}});
  const PlanResult result = pipeline::planPart(request, {});
  EXPECT_EQ(result.job.report.item().tried.size(), 1u);
  EXPECT_EQ(first(result).kind, FindingKind::OpenRims);
}

// The cup, with one corner of its rim raised.
std::shared_ptr<const project::LoadedPart> cupWith(double raisedMm) {
  geometry::TriangleMesh m = *cup()->source;
  for (Eigen::Vector3d& v : m.vertices)
    if (v.z() > 10.0 && v.x() > 20.0 && v.y() > 20.0)
      v.z() += raisedMm;
  return project::loadedFrom("raised.stl", std::make_shared<geometry::TriangleMesh>(std::move(m)),
                             {}, true, {});
}

TEST(OpenPart, FlatRimsAreClosedWithANote) {
  const PlanResult result = planned(cup(), "auto");
  EXPECT_EQ(first(result).kind, FindingKind::RimsClosed);
  EXPECT_FALSE(first(result).blocking);
  EXPECT_NEAR(result.job.report.item().model.volumeMm3, 30 * 30 * 20, 1e-6);
  EXPECT_EQ(first(planned(cupWith(0.1), "auto")).kind, FindingKind::RimsClosed) << "nearly flat";
  EXPECT_EQ(first(planned(cupWith(6.0), "auto")).kind, FindingKind::OpenRims);
  EXPECT_EQ(first(planned(sheet(), "auto")).kind, FindingKind::SheetModel);
}

TEST(OpenPart, IsClosedOnTheUsersWord) {
  const PlanResult result = planned(cup(), "close");
  EXPECT_EQ(first(result).kind, FindingKind::RimsClosed);
  EXPECT_FALSE(first(result).blocking);
  EXPECT_TRUE(result.job.report.item().model.watertight);
  EXPECT_NEAR(result.job.report.item().model.volumeMm3, 30 * 30 * 20, 1e-6);
}

TEST(OpenPart, BecomesAWallOfTwoBeads) {
  const PlanResult result = planned(cup(), "thicken");
  EXPECT_EQ(first(result).kind, FindingKind::SurfaceThickened);
  EXPECT_TRUE(result.job.report.item().model.watertight);
  const double wall = pipeline::openSurfaceWallMm(result.tooling().first().process);
  EXPECT_NEAR(result.job.report.item().model.boundsMm.sizes().x(), 30.0 + wall, 0.05);
  EXPECT_NEAR(result.job.report.item().model.volumeMm3, (900 + 4 * 600) * wall, 0.1 * 3300 * wall);
}

// The cup, and beside it a body in the air.
std::shared_ptr<const project::LoadedPart> cupBeside(const geometry::TriangleMesh& other) {
  geometry::TriangleMesh m = *cup()->source;
  test::append(m, other);
  return project::loadedFrom("both.stl", std::make_shared<geometry::TriangleMesh>(std::move(m)), {},
                             true, {});
}
// Of which closing the cup does not make a solid.
std::shared_ptr<const project::LoadedPart> cupAndBowTie() {
  return cupBeside(test::bowTie({40, 0, 15}, 20.0, 12.0, 8.0, 20.0));
}

// A tube without bottom and top, or a part of it.
std::shared_ptr<const project::LoadedPart> tube(double turns = 1.0, double heightMm = 6.0) {
  constexpr int kSides = 96;
  geometry::TriangleMesh m;
  const bool whole = turns >= 1.0;
  for (const double z : {0.0, heightMm})
    for (int i = 0; i < kSides; ++i) {
      const double a = 2.0 * std::numbers::pi * turns * i / kSides;
      m.vertices.emplace_back(15.0 * std::cos(a), 15.0 * std::sin(a), z);
    }
  for (int i = 0; i < (whole ? kSides : kSides - 1); ++i) {
    const int j = (i + 1) % kSides;
    m.triangles.push_back({i, j, j + kSides});
    m.triangles.push_back({i, j + kSides, i + kSides});
  }
  return project::loadedFrom("tube.stl", std::make_shared<geometry::TriangleMesh>(std::move(m)), {},
                             true, {});
}

PlanResult plannedWall(std::shared_ptr<const project::LoadedPart> part, const std::string& mode,
                       bool spiral) {
  PlanRequest request;
  request.item().loaded = std::move(part);
  request.choices.item().mode = mode;
  test::giveParameters(
      request.choices,
      {{"openSurfaces", "wall"}, {"spiral", spiral ? "true" : "false"}, {"prime", "none"}});
  return pipeline::planPart(request, {});
}

TEST(OpenPart, BecomesOneWallOfOneBead) {
  for (const char* mode : {"flat", "curved"})
    for (const double turns : {1.0, 0.6})
      for (const bool spiral : {false, true}) {
        const PlanResult result = plannedWall(tube(turns), mode, spiral);
        const plan::Findings& findings = result.job.report.findings;
        EXPECT_EQ(first(result).kind, FindingKind::SurfaceAsWall);
        EXPECT_TRUE(std::ranges::none_of(findings, &plan::Finding::blocking)) << mode << turns;
        EXPECT_EQ(result.job.reached, Stage::Replay);
        const plan::ToolPlan& made = *result.job.toolPlan;
        const bool winds = spiral && turns >= 1.0;
        EXPECT_EQ(made.paths.size(),
                  winds ? 1u : static_cast<std::size_t>(made.paths.back().layer) + 1)
            << mode << turns;
        EXPECT_EQ(made.paths.front().closed, !winds && turns >= 1.0);
        const double bead = result.tooling().first().process.beadWidthMm;
        for (std::size_t i = 0; i < made.waypointCount() && turns >= 1.0; ++i)
          EXPECT_NEAR(made.widthMm[i], bead, 0.035 * bead) << mode;
      }
}

TEST(OpenPart, AClosedSolidIsAVaseOnItsBottom) {
  PlanRequest request;
  request.item().loaded = project::loadedFrom(
      "box.stl", std::make_shared<geometry::TriangleMesh>(test::box({0, 0, 0}, {30, 30, 8})), {},
      true, {});
  request.choices.item().mode = "flat";
  test::giveParameters(request.choices, {{"spiral", "true"}, {"prime", "none"}});
  const PlanResult result = pipeline::planPart(request, {});
  EXPECT_TRUE(std::ranges::none_of(result.job.report.findings, &plan::Finding::blocking));
  const std::vector<plan::ToolPath>& paths = result.job.toolPlan->paths;
  EXPECT_EQ(std::ranges::count_if(paths, [](const plan::ToolPath& p) { return p.layer >= 3; }), 1);
  EXPECT_EQ(paths.back().layer, 3);
  EXPECT_FALSE(paths.back().closed);
}

TEST(OpenPart, IsRefusedAsAWallIfItCrossesItself) {
  geometry::TriangleMesh m;
  m.vertices = {{0, 0, 0},    {30, 0, 0},  {30, 0, 20},  {0, 0, 20},
                {15, -15, 0}, {15, 15, 0}, {15, 15, 20}, {15, -15, 20}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  auto part = project::loadedFrom(
      "cross.stl", std::make_shared<geometry::TriangleMesh>(std::move(m)), {}, true, {});
  EXPECT_THROW(plannedWall(std::move(part), "flat", false), base::Error);
}

TEST(OpenPart, RepairedAndRemainingDefectsAreNamed) {
  const PlanResult closed = planned(cup(), "close");
  EXPECT_THAT(base::english(closed.job.report.item().model.repairs),
              ::testing::Contains(::testing::HasSubstr("closed 1 hole")));
  EXPECT_EQ(closed.job.report.findings.size(), 1u) << "no defect is left";
  for (const char* choice : {"close", "thicken"}) {
    const PlanResult result = planned(cupAndBowTie(), choice);
    const plan::Findings& all = result.job.report.findings;
    EXPECT_GT(std::ranges::count(all, FindingKind::MeshDefect, &plan::Finding::kind), 0) << choice;
    EXPECT_NE(first(result).kind, FindingKind::MeshDefect) << choice;
  }
}

TEST(OpenPart, ModeAutoCutsNoPiecesOutOfItsDefects) {
  const auto reasonOfPieces = [](std::shared_ptr<const project::LoadedPart> part) {
    PlanRequest request;
    request.item().loaded = std::move(part);
    request.choices.item().automatic = true;
    test::giveParameters(request.choices, {{"openSurfaces", "close"}});
    request.until = Stage::Decompose;
    for (const project::TriedReport& row : pipeline::planPart(request, {}).job.report.item().tried)
      if (row.mode == "planar")
        return base::english(row.reason);
    return std::string("not tried");
  };
  EXPECT_THAT(reasonOfPieces(cupAndBowTie()), ::testing::HasSubstr("mesh with defects"));
  EXPECT_THAT(reasonOfPieces(cupBeside(test::box({40, -6, 15}, {60, 6, 35}))),
              ::testing::Not(::testing::AnyOf(::testing::HasSubstr("mesh with defects"),
                                              ::testing::Eq("not tried"))));
}

TEST(OpenPart, ItsVoxelsAreOfTheMeshAsChosen) {
  pipeline::StageCache cache;
  const auto voxels = [](const char* choice, pipeline::StageCache* kept) {
    PlanRequest request;
    request.item().loaded = cup();
    request.choices.item().mode = "curved";
    test::giveParameters(request.choices, {{"openSurfaces", choice}});
    request.until = Stage::Decompose;
    return pipeline::planPart(request, {}, kept).job.report.item().decomposition.voxels;
  };
  const std::size_t wall = voxels("thicken", &cache), solid = voxels("close", &cache);
  EXPECT_EQ(solid, voxels("close", nullptr));
  EXPECT_GT(solid, wall + 1000);
}

TEST(OpenPart, ItsRemediesUnblockThePlan) {
  const PlanResult refused = planned(cup(), "refuse");
  const std::vector<pipeline::RemedyAction> offers =
      pipeline::remediesFor(first(refused), refused.job.choices);
  ASSERT_EQ(offers.size(), 3u);
  for (const pipeline::RemedyAction& offer : offers) {
    PlanRequest request;
    request.item().loaded = cup();
    request.choices = offer.choices;
    request.until = Stage::Load;
    const PlanResult result = pipeline::planPart(request, {});
    EXPECT_FALSE(first(result).blocking) << offer.remedy->name;
  }
}

TEST(OpenPart, AsItWasReadItIsNotJudged) {
  EXPECT_FALSE(cup(false)->open);
  EXPECT_TRUE(cup(true)->open);
}

TEST(OpenPart, IsStillOpenInItsProject) {
  const PlanResult result = planned(cup(), "refuse");
  const test::TemporaryFolder folder;
  project::writeJob(folder / "cup.voluta", result.job);
  const project::Job back = project::readJob(folder / "cup.voluta", pipeline::allParameters());
  ASSERT_TRUE(back.item().loaded->open);
  EXPECT_EQ(back.item().loaded->open->rims, 1u);
  EXPECT_EQ(back.item().loaded->open->capShare, result.job.item().loaded->open->capShare);
}

} // namespace
