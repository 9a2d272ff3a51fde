// The placement of a part and its planned platform, as the window queries them.
#include "geometry/placement.h"
#include "helpers/lathe_parts.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "pipeline/cell_plate.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"

#include <gtest/gtest.h>

using namespace voluta;
using pipeline::PlanRequest;
using pipeline::PlanResult;
using project::Stage;

namespace {

PlanResult placed(PlanRequest request) {
  request.until = Stage::Load;
  return pipeline::planPart(request, {});
}

// Upright, as it comes from a drawing.
PlanRequest tubeOnRod() {
  geometry::TriangleMesh tube = test::revolved(test::tubeSection(), 48);
  for (Eigen::Vector3d& p : tube.vertices)
    p = Eigen::Vector3d(p.y(), p.z(), p.x());
  PlanRequest request;
  request.item().loaded = project::loadedFrom(
      "tube.stl", std::make_shared<geometry::TriangleMesh>(std::move(tube)), {}, true, {});
  request.choices.item().mode = "lathe";
  request.choices.cell = "lathe";
  request.choices.tool().process = "fdm-0.35";
  request.choices.item().platform = project::Platform("rod:5x200");
  return request;
}

// The part is at its placement.
void expectFlat(const PlanResult& result) {
  ASSERT_TRUE(result.job.item().placement);
  const double scale =
      result.job.item().scale * pipeline::unitMm(*result.job.item().loaded, result.job.choices);
  const auto part =
      geometry::place(*result.job.item().loaded->mesh, scale, *result.job.item().placement);
  ASSERT_EQ(part.vertices.size(), result.job.item().part->vertices.size());
  for (std::size_t i = 0; i < part.vertices.size(); ++i)
    EXPECT_LT((part.vertices[i] - result.job.item().part->vertices[i]).norm(), 1e-9);
}

// A plate that carries the part but has no room for the prime or the brim is passed over for one
// that has.
TEST(PlacePart, ThePlateHasRoomForThePrimeAndTheBrim) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell =
      robot::loadCell("ur5-fixed", process, {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}});
  const auto radiusFor = [&](double halfMm, const pipeline::PlateNeeds& needs) {
    const auto box = test::loadedBox({-halfMm, -halfMm, 0}, {halfMm, halfMm, 10});
    double radius = 0.0;
    for (const Eigen::Vector2d& p : pipeline::cellPlate(cell, *box->mesh, needs))
      radius = std::max(radius, p.norm());
    return radius;
  };
  const pipeline::PlateNeeds none, line{.prime = true, .primeLengthMm = 30.0},
      ring{.prime = true, .primeIsRing = true, .primeLengthMm = 30.0}, narrow{.brimMm = 5.0},
      wide{.brimMm = 12.0};
  EXPECT_NEAR(radiusFor(15.0, none), 30.0, 0.5);
  EXPECT_NEAR(radiusFor(15.0, line), 45.0, 0.5);
  EXPECT_NEAR(radiusFor(15.0, ring), 45.0, 0.5);
  EXPECT_NEAR(radiusFor(15.0, narrow), 30.0, 0.5);
  EXPECT_NEAR(radiusFor(15.0, wide), 45.0, 0.5);
  // Where none has room for it, the smallest that carries the part.
  EXPECT_NEAR(radiusFor(85.0, none), 125.0, 0.5);
  EXPECT_NEAR(radiusFor(85.0, ring), 125.0, 0.5);
  EXPECT_NEAR(radiusFor(85.0, wide), 125.0, 0.5);
}

TEST(PlacePart, PlacementByTheModeIsKept) {
  const PlanResult result = placed(tubeOnRod());
  expectFlat(result);
  EXPECT_LT(result.job.item().placement->liftMm, -1.0) << "around the rod, below z = 0";
  const test::TemporaryFolder folder;
  project::writeJob(folder / "tube.voluta", result.job);
  project::Job back = project::readJob(folder / "tube.voluta", pipeline::allParameters());
  ASSERT_TRUE(back.item().placement);
  EXPECT_EQ(back.item().placement->rotation.coeffs(),
            result.job.item().placement->rotation.coeffs());
  EXPECT_EQ(back.item().placement->liftMm, result.job.item().placement->liftMm);
  // Projects of before it was kept.
  back.item().placement.reset();
  expectFlat(pipeline::resultOf(back));
}

TEST(PlacePart, PlacementByASearchIsReturned) {
  expectFlat(placed(test::boxRequest({{"orient", "leastRisky"}})));
}

TEST(PlacePart, PlannedPlatformIsThatOfTheDecomposition) {
  for (const char* platform : {"fit:0", "fit:2", "disc:40", "rect:30x40"}) {
    PlanRequest request = test::boxRequest();
    request.choices.item().platform = project::Platform(platform);
    request.until = Stage::Decompose;
    const PlanResult result = pipeline::planPart(request, {});
    const auto planned = pipeline::plannedPlatform(*result.item().placed, result.resolved());
    EXPECT_EQ(planned.polygon, result.job.item().platform.polygon) << platform;
  }
}

TEST(PlacePart, AnotherPlatformHasAnotherKey) {
  project::Choices choices;
  const std::string key = pipeline::plannedPlatformKey(pipeline::resolve(choices));
  choices.item().parameters["walls"] = "1";
  EXPECT_EQ(pipeline::plannedPlatformKey(pipeline::resolve(choices)), key);
  choices.item().platform = project::Platform("disc:40");
  EXPECT_NE(pipeline::plannedPlatformKey(pipeline::resolve(choices)), key);
}

} // namespace
