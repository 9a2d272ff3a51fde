// Files for making the pedestal, and the place of a platform in its cell.
#include "base/files.h"
#include "geometry/append_mesh.h"
#include "geometry/convex_polygon.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "pipeline/pedestal.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "project/loaded_part.h"
#include "robot/plate.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;

PlanResult planned(const project::Choices& choices, const geometry::TriangleMesh& mesh) {
  PlanRequest request;
  request.item().loaded = project::loadedFrom(
      "part.stl", std::make_shared<geometry::TriangleMesh>(mesh), {}, true, kCtx);
  request.choices = choices;
  request.until = project::Stage::Decompose;
  return planPart(request, kCtx);
}

bool tells(const PlanResult& plan, plan::FindingKind kind) {
  return std::ranges::any_of(plan.job.report.findings,
                             [&](const plan::Finding& f) { return f.kind == kind; });
}

project::Choices flat(const char* platform) {
  project::Choices choices;
  choices.item().mode = "flat";
  choices.item().platform = project::Platform(platform);
  return choices;
}

TEST(Pedestal, IsTheOutlineAndTheSolidOfThePlatform) {
  const PlanResult plan = planned(flat("fit:2"), test::box({-9, -6, 0}, {9, 6, 5}));
  const std::vector<plan::ProgramFile> files = pedestalFiles(plan);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].name, "pedestal.dxf");
  std::size_t corners = 0;
  for (std::size_t at = 0; (at = files[0].text.find("\nVERTEX\n", at)) != std::string::npos; ++at)
    ++corners;
  EXPECT_EQ(corners, plan.job.item().platform.polygon.size());
  const test::TemporaryFolder folder;
  base::writeFile(folder.path() / files[1].name, files[1].text);
  const geometry::TriangleMesh solid = geometry::readMesh(folder.path() / files[1].name).mesh;
  double area = 0.0;
  const auto& outline = plan.job.item().platform.polygon;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_GT(area, 18.0 * 12.0);
  EXPECT_NEAR(geometry::volume(solid), 5.0 * area, 1e-3 * area)
      << "the cell's plates are 5 mm thick";
  EXPECT_NEAR(geometry::bounds(solid).max().z(), 0.0, 1e-6);
}

TEST(Pedestal, HasAFootWherePartsAreBesideTheirMiddle) {
  geometry::TriangleMesh table = test::box({20, -5, 0}, {30, 5, 10}); // one leg, at its end
  geometry::appendMesh(table, test::box({-30, -5, 9}, {30, 5, 15}));
  const PlanResult plan = planned(flat("fit:2"), table);
  EXPECT_FALSE(tells(plan, plan::FindingKind::PlatformAdrift));
  const robot::Prism* foot = robot::footOf(*plan.cell);
  ASSERT_TRUE(foot);
  EXPECT_NEAR(robot::platformGapMm(*plan.cell), 18.0 - 14.0, 0.5) << "of the plate alone";
  // Around the stem, 14 mm thick, and the whole outline.
  EXPECT_TRUE(geometry::inConvexPolygon(foot->polygon, {-13.5, 0.0}));
  EXPECT_FALSE(geometry::inConvexPolygon(foot->polygon, {-15.0, 0.0}));
  for (const Eigen::Vector2d& corner : plan.job.item().platform.polygon)
    EXPECT_TRUE(geometry::inConvexPolygon(foot->polygon, corner));
  EXPECT_LT(foot->zMax, -2.0) << "clear of the first layer";
  const std::vector<plan::ProgramFile> files = pedestalFiles(plan);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_NE(files[0].text.find("\n8\nFOOT\n"), std::string::npos);
  const test::TemporaryFolder folder;
  base::writeFile(folder.path() / files[1].name, files[1].text);
  const geometry::TriangleMesh solid = geometry::readMesh(folder.path() / files[1].name).mesh;
  const auto area = [](const std::vector<Eigen::Vector2d>& outline) {
    double sum = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
      sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return sum;
  };
  const double volume = 2.5 * area(plan.job.item().platform.polygon) + 2.5 * area(foot->polygon);
  EXPECT_NEAR(geometry::volume(solid), volume, 1e-3 * volume) << "one body";
  const auto isBefore = [&](int a, int b) {
    return std::ranges::lexicographical_compare(solid.vertices[static_cast<std::size_t>(a)],
                                                solid.vertices[static_cast<std::size_t>(b)]);
  };
  EXPECT_TRUE(std::ranges::is_sorted(solid.triangles, [&](const auto& a, const auto& b) {
    return std::ranges::lexicographical_compare(a, b, isBefore);
  })) << "the file is the same each time";
}

TEST(Pedestal, IsNotMadeOfAPlateOfTheCell) {
  EXPECT_TRUE(pedestalFiles(planned(flat("disc:80"), test::box({-9, -6, 0}, {9, 6, 5}))).empty());
}

TEST(PlatformsPlace, OnesThatWouldFloatBlock) {
  const geometry::TriangleMesh box = test::box({-9, -6, 0}, {9, 6, 5});
  EXPECT_FALSE(tells(planned(flat("fit:2"), box), plan::FindingKind::PlatformAdrift));
  project::Choices beside = flat("fit:2");
  beside.item().placement.centreMm = {150.0, 0.0};
  const PlanResult adrift = planned(beside, box);
  ASSERT_TRUE(tells(adrift, plan::FindingKind::PlatformAdrift));
  EXPECT_FALSE(nothingBlocks(adrift.job.report));
  // The plate's edge is 11 mm nearer, the stem is 14 mm thick.
  EXPECT_NEAR(robot::platformGapMm(*adrift.cell), 150.0 - 11.0 - 14.0, 1.5);
  beside.item().platform = project::Platform("disc:80");
  EXPECT_EQ(robot::platformGapMm(*planned(beside, box).cell), 0.0) << "it is where the cell has it";
}

TEST(PartSize, OddSizesGiveAFindingAboutUnitsAndStopThePlan) {
  project::Choices choices = flat("disc:80");
  const geometry::TriangleMesh metres = test::box({0, 0, 0}, {0.02, 0.03, 0.01});
  const PlanResult tiny = planned(choices, metres);
  ASSERT_TRUE(tells(tiny, plan::FindingKind::TinyPart));
  EXPECT_EQ(*tiny.job.reached, project::Stage::Load) << "nothing can be planned for it";
  choices.item().units = "m";
  const PlanResult right = planned(choices, metres);
  EXPECT_FALSE(tells(right, plan::FindingKind::TinyPart));
  EXPECT_NEAR(right.job.report.item().model.volumeMm3, 20.0 * 30.0 * 10.0, 1e-6);
  choices.item().units = "mm";
  EXPECT_TRUE(
      tells(planned(choices, test::box({0, 0, 0}, {2500, 100, 100})), plan::FindingKind::HugePart));
}

TEST(PartSize, ThinPartsFirstNameTheScaleAtWhichTheyPrint) {
  const PlanResult plan = planned(flat("disc:80"), test::box({-15, -0.25, 0}, {15, 0.25, 10}));
  ASSERT_FALSE(plan.job.report.findings.empty());
  const plan::Finding& first = plan.job.report.findings.front();
  ASSERT_EQ(first.kind, plan::FindingKind::ThinPart);
  EXPECT_EQ(plan::englishRemedy(first),
            "print it at scale 2, or use a process with narrower beads");
  EXPECT_TRUE(first.blocking) << "so that it comes first in the window too";
  EXPECT_FALSE(tells(planned(flat("disc:80"), test::box({-15, -1, 0}, {15, 1, 10})),
                     plan::FindingKind::ThinPart));
}

// A fin on a bar: reported, and left to the replay to judge.
TEST(PartSize, AThinWallAmongOthersDoesNotBlock) {
  geometry::TriangleMesh part = test::box({-15, -2, 0}, {15, 2, 3});
  geometry::appendMesh(part, test::box({-15, -0.25, 3}, {15, 0.25, 9}));
  const PlanResult plan = planned(flat("disc:80"), part);
  const auto thin = std::ranges::find(plan.job.report.findings, plan::FindingKind::ThinPart,
                                      &plan::Finding::kind);
  ASSERT_NE(thin, plan.job.report.findings.end());
  EXPECT_FALSE(thin->blocking);
}

} // namespace
