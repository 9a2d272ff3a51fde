// Where the nozzle is filled: beside the part where the plate has room, else in the air beside it.
#include "helpers/shapes.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "process/process.h"
#include "robot/cell.h"
#include "toolpath/prime_path.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::toolpath {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::vector<Vector2d> square(double sideMm) {
  const double a = 0.5 * sideMm;
  return {{-a, -a}, {a, -a}, {a, a}, {-a, a}};
}
std::vector<Vector3d> corners(double sideMm) {
  std::vector<Vector3d> points;
  for (const Vector2d& p : square(sideMm))
    points.emplace_back(p.x(), p.y(), 0.8);
  return points;
}
// From a square about the origin.
double offsetOf(double sideMm, const Vector2d& p) {
  const Vector2d out = (p.cwiseAbs() - Vector2d::Constant(0.5 * sideMm)).cwiseMax(0.0);
  return out.norm();
}

TEST(PrimePath, aLineIsBesideThePart) {
  // The first path begins at (-20, -20): the line is below or to the left, 30 mm from the middle.
  const PrimePlace place = primePlace(square(200), corners(40), {0, 0}, false, 30.0, 1.2);
  EXPECT_TRUE(place.onPlate);
  ASSERT_EQ(place.corners.size(), 2u);
  EXPECT_NEAR((place.corners[1] - place.corners[0]).norm(), 30.0, 1e-9);
  for (const Vector2d& p : place.corners) {
    EXPECT_GE(offsetOf(40, p), kPrimeOffsetMm - 1e-9);
    EXPECT_LE(p.cwiseAbs().maxCoeff(), 100.0 - kPrimeFromEdgeMm);
  }
  // It ends nearer to the part's begin than it begins.
  EXPECT_LE((place.corners[1] - Vector2d(-20, -20)).norm(),
            (place.corners[0] - Vector2d(-20, -20)).norm());
}

TEST(PrimePath, aRingIsRoundThePart) {
  const PrimePlace place = primePlace(square(100), corners(40), {0, 0}, true, 30.0, 1.2);
  EXPECT_TRUE(place.onPlate);
  EXPECT_LT((place.corners.front() - place.corners.back()).norm(), 1e-9);
  for (std::size_t i = 1; i < place.corners.size(); ++i)
    for (const double t : {0.0, 0.5, 1.0}) {
      const Vector2d p = place.corners[i - 1] + t * (place.corners[i] - place.corners[i - 1]);
      EXPECT_GE(offsetOf(40, p), kPrimeOffsetMm - 1e-9);
      EXPECT_LE(p.cwiseAbs().maxCoeff(), 50.0 - kPrimeFromEdgeMm);
    }
}

// A ring needs more room than a line, a line more than half of it, and a pedestal has none.
TEST(PrimePath, whereThePlateHasNoRoomItIsInTheAirBesideIt) {
  EXPECT_FALSE(primePlace(square(67), corners(40), {0, 0}, true, 30.0, 1.2).onPlate);
  const PrimePlace half = primePlace({{-22, -13}, {40, -13}, {40, 13}, {-22, 13}}, corners(40),
                                     {0, 0}, false, 30.0, 1.2);
  EXPECT_TRUE(half.onPlate);
  EXPECT_NEAR((half.corners[1] - half.corners[0]).norm(), 15.0, 1e-9);
  const PrimePlace air = primePlace(square(42), corners(40), {90, 0}, false, 30.0, 1.2);
  EXPECT_FALSE(air.onPlate);
  for (const Vector2d& p : air.corners)
    EXPECT_GE(offsetOf(42, p), kPrimeOutsideMm - 1e-9);
  // On the side where the arm rests.
  EXPECT_GT(air.corners.front().x(), 30.0);
}

// One path of four waypoints.
plan::ToolPlan onePath() {
  plan::ToolPlan plan;
  plan.position = corners(40);
  plan.direction.assign(4, Vector3d::UnitZ());
  plan.widthMm.assign(4, 1.2f);
  plan.heightMm.assign(4, 0.8f);
  plan.speedMmPerS.assign(4, 20.0f);
  plan.paths.push_back({.first = 0, .count = 4});
  return plan;
}

TEST(PrimePath, isTheFirstOfThePlanAndWaste) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-moving", process, square(200));
  plan::ToolPlan plan = onePath();
  ToolpathOptions options;
  addPrimePath(plan, cell, process::Tooling(process), options);
  EXPECT_FALSE(plan.primes());
  EXPECT_EQ(plan.paths.size(), 1u);
  options.prime = "line";
  addPrimePath(plan, cell, process::Tooling(process), options);
  EXPECT_TRUE(plan.primes());
  ASSERT_EQ(plan.paths.size(), 2u);
  EXPECT_EQ(plan.paths[0].kind, plan::PathKind::Prime);
  EXPECT_EQ(plan.paths[0].count, 31u);
  EXPECT_EQ(plan.paths[1].first, 31u);
  EXPECT_EQ(plan.waypointCount(), 35u);
  for (std::size_t i = 0; i < 31; ++i)
    EXPECT_NEAR(plan.position[i].z(), process.layerHeightMm, 1e-12);
  EXPECT_EQ(plan.position[31], corners(40)[0]);
}

// The other tool of the job may not print at all.
TEST(PrimePath, isPrintedByTheToolThatPrintsFirst) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  const process::Process process = process::loadProcess("fdm-1.0");
  process::Process narrow = process;
  narrow.beadWidthMm = 0.9;
  const process::Tooling tooling({{process}, {narrow}});
  const robot::Cell cell = robot::loadCell("ur5-moving", process, square(200));
  plan::ToolPlan plan = onePath();
  plan.paths[0].tool = plan.paths[0].item = 1;
  ToolpathOptions options;
  options.prime = "line";
  addPrimePath(plan, cell, tooling, options);
  ASSERT_EQ(plan.paths.size(), 2u);
  EXPECT_EQ(plan.paths[0].tool, 1);
  EXPECT_EQ(plan.paths[0].item, 1);
  EXPECT_FLOAT_EQ(plan.widthMm[0], 0.9f);
}

// A path that falls gives a finding with its place; a path on the plate gives none.
TEST(PrimePath, findingNamesThePlaceWhereItFalls) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  const process::Process process = process::loadProcess("fdm-1.0");
  const plan::ToolPlan plan = onePath();
  ToolpathOptions options;
  options.prime = "line";
  for (const double sideMm : {200.0, 42.0}) {
    plan::ToolPlan primed = plan;
    const auto reported =
        addPrimePath(primed, robot::loadCell("ur5-moving", process, square(sideMm)),
                     process::Tooling(process), options);
    EXPECT_EQ(primed.paths[0].kind, plan::PathKind::Prime);
    EXPECT_EQ(reported.has_value(), primed.isPrimeInAir()) << sideMm;
    EXPECT_EQ(reported.has_value(), sideMm < 100.0);
    if (reported) {
      EXPECT_EQ(reported->kind, plan::FindingKind::PrimeFalls);
      EXPECT_FALSE(reported->blocking);
      ASSERT_TRUE(reported->where);
      EXPECT_EQ(*reported->where, primed.position[0]);
    }
  }
}

} // namespace
// A bead of 50 mm has room beside the part and at the edge.
TEST(PrimePath, wideBeadsKeepTheirDistance) {
  for (const double width : {1.2, 4.0, 7.2, 50.0}) {
    SCOPED_TRACE(width);
    const PrimePlace place = primePlace(square(600), corners(200), {0, 0}, false, 100.0, width);
    ASSERT_TRUE(place.onPlate);
    for (const Vector2d& p : place.corners) {
      EXPECT_GE(offsetOf(200, p), std::max(kPrimeOffsetMm, 2.0 * width) - 1e-9);
      EXPECT_LE(p.cwiseAbs().maxCoeff(), 600.0 - width);
    }
  }
}

} // namespace voluta::toolpath
