// Printing times against closed forms.
#include "placement/printing_time.h"

#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "process/bead_model.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta::placement {
namespace {

using Eigen::Vector3d;

StandingPart standing(const geometry::TriangleMesh& mesh) {
  const Vector3d size = geometry::bounds(mesh).sizes();
  StandingPart part;
  part.volumeMm3 = geometry::volume(mesh);
  part.heightMm = size.z();
  part.contactMm2 = size.x() * size.y();
  part.acrossMm = size.head<2>().norm();
  part.surface = standingSurface(mesh, Vector3d::UnitZ());
  return part;
}

double flowOf(const process::Process& p) {
  return process::beadArea(p.beadWidthMm, p.layerHeightMm) * p.speedMmPerS;
}

TEST(StandingSurface, IsThatOfABoxOnEachOfItsSides) {
  const geometry::TriangleMesh box = test::box({0, 0, 0}, {30, 20, 10});
  const StandingSurface flat = standingSurface(box, Vector3d::UnitZ());
  EXPECT_NEAR(flat.outlinesMm2, 2 * (30 + 20) * 10, 1e-9);
  EXPECT_NEAR(flat.steepMm2, flat.outlinesMm2, 1e-9);
  EXPECT_NEAR(flat.upMm2, 600.0, 1e-9);
  EXPECT_NEAR(flat.downMm2, 600.0, 1e-9);
  const StandingSurface onEnd = standingSurface(box, -Vector3d::UnitX());
  EXPECT_NEAR(onEnd.outlinesMm2, 2 * (20 + 10) * 30, 1e-9);
  EXPECT_NEAR(onEnd.upMm2, 200.0, 1e-9);
}

TEST(StandingSurface, OfABallIntegratesItsCircles) {
  constexpr double kRadius = 20.0;
  const StandingSurface ball =
      standingSurface(test::sphere({0, 0, 0}, kRadius), Vector3d(1, 2, 2) / 3.0);
  const double outlines = base::kPi * base::kPi * kRadius * kRadius; // of 2 pi sqrt(r² - z²)
  EXPECT_NEAR(ball.outlinesMm2, outlines, 0.02 * outlines);
  // Above 45 degrees, projected: half of the middle section.
  const double cap = 0.5 * base::kPi * kRadius * kRadius;
  EXPECT_NEAR(ball.upMm2, cap, 0.05 * cap);
  EXPECT_NEAR(ball.downMm2, cap, 0.05 * cap);
}

TEST(PrintingTime, OfASolidPartIsVolumeByFlowAndItsStarts) {
  process::Process p;
  StandingPart part;
  part.volumeMm3 = 100.0 * flowOf(p);
  part.heightMm = 8.0;
  part.acrossMm = 50.0;
  EXPECT_NEAR(estimatedSeconds(part, {}, p), 100.0 + 10 * (3 * (0.2 + 0.2) + 0.5), 1e-9);
  Filling slow;
  slow.minLayerS = 60.0;
  EXPECT_NEAR(estimatedSeconds(part, slow, p), 600.0, 1e-9) << "layers wait";
  part.heightMm = 0.0;
  EXPECT_NEAR(estimatedSeconds(part, {}, p), 100.0, 1e-9);
  p.maxFlowMm3PerS = 0.5 * flowOf(p);
  EXPECT_NEAR(estimatedSeconds(part, {}, p), 200.0, 1e-9);
}

TEST(PrintingTime, OuterWallsHaveTheirOwnSpeed) {
  process::Process p;
  const StandingPart part = standing(test::box({0, 0, 0}, {30, 20, 10}));
  Filling one;
  one.walls = 1;
  const double before = estimatedSeconds(part, one, p);
  p.features.of(process::Feature::OuterWall).speedMmPerS = 0.5 * p.speedMmPerS;
  const double wall = process::hatchOf(p.beadWidthMm, p.layerHeightMm) * 1000.0;
  EXPECT_NEAR(estimatedSeconds(part, one, p) - before, wall / flowOf(p), 1e-9);
}

// Within its walls and skins a box leaves a smaller box.
TEST(PrintingTime, OfASparsePartCountsWallsSkinsAndTheRestByItsDensity) {
  const process::Process p;
  const StandingPart part = standing(test::box({0, 0, 0}, {40, 40, 25}));
  Filling filling;
  filling.density = 0.2;
  filling.topMm = 2.4;
  filling.bottomMm = 1.6;
  const double walls = 2.0 * process::hatchOf(p.beadWidthMm, p.layerHeightMm);
  const double within = std::pow(40.0 - 2.0 * walls, 2) * (25.0 - 4.0);
  EXPECT_NEAR(sparseVolume(part, filling, p), within, 1e-6);
  EXPECT_NEAR(estimatedSeconds(part, {}, p) - estimatedSeconds(part, filling, p),
              0.8 * within / flowOf(p), 1e-6);
  const StandingPart sheet = standing(test::box({0, 0, 0}, {40, 40, 2}));
  EXPECT_NEAR(sparseVolume(sheet, filling, p), 0.0, 1e-6) << "all of it is skin";
}

TEST(PrintingTime, OfASpiralIsThatOfItsBottomAndOneWall) {
  const process::Process p;
  const StandingPart part = standing(test::box({0, 0, 0}, {40, 40, 80}));
  Filling spiral;
  spiral.spiral = true;
  const double turns = 80.0 / p.layerHeightMm;
  EXPECT_NEAR(estimatedSeconds(part, spiral, p), turns * 160.0 / p.speedMmPerS, 1e-6);
  spiral.bottomMm = 2.0 * p.layerHeightMm;
  const double bottom = 1600.0 * spiral.bottomMm / flowOf(p);
  const double starts = 2 * (3 * (0.2 + 0.2) + part.acrossMm / p.travelSpeedMmPerS);
  EXPECT_NEAR(estimatedSeconds(part, spiral, p),
              (turns - 2.0) * 160.0 / p.speedMmPerS + bottom + starts, 1e-6);
}

} // namespace
} // namespace voluta::placement
