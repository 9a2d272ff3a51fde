// Material that stays where the cutter cannot reach is measured with its place.
#include "milling/cut_verdict.h"
#include "milling/left_material.h"
#include "milling/mill_program.h"

#include "geometry/subtract.h"
#include "helpers/shapes.h"
#include "program/gcode/gcode_milling.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta::milling {
namespace {

using Eigen::Vector3d;

geometry::TriangleMesh without(const geometry::TriangleMesh& part, const Vector3d& low,
                               const Vector3d& high) {
  return *geometry::subtract(part, test::box(low, high));
}

const geometry::TriangleMesh kBlock = test::box({-20, -10, 0}, {20, 10, 12});

CutVerdict milled(const geometry::TriangleMesh& part) {
  MillRule rule;
  rule.data = *cuttingDataFor("soft-plastic");
  const MillPlan plan = planMilling(part, rule, {});
  return judgeCuts(program::readMillingGcode(writeMilling(plan, rule, "part")), plan, rule, {});
}

TEST(LeftMaterial, APlainBlockIsComplete) {
  const CutVerdict v = milled(kBlock);
  EXPECT_TRUE(v.isComplete()) << v.left.volumeMm3 << " at " << v.left.atMm.transpose();
}

TEST(LeftMaterial, ASlotNarrowerThanTheCutterStays) {
  const CutVerdict v = milled(without(kBlock, {-25, -1, 4}, {25, 1, 20}));
  EXPECT_TRUE(v.passed);
  EXPECT_FALSE(v.isComplete());
  // 40 x 2 x 8 mm, with the ridge in its mouth.
  EXPECT_GT(v.left.volumeMm3, 640.0);
  EXPECT_LT(v.left.volumeMm3, 660.0);
  EXPECT_NEAR(v.left.atMm.y(), 0.0, 1.1);
  EXPECT_NEAR(v.left.atMm.z(), 8.0, 0.5);
  EXPECT_NEAR(v.left.thickestMm, 8.0, 0.5);
}

TEST(LeftMaterial, ASlotOnTheLowerSideStays) {
  const CutVerdict v = milled(without(kBlock, {-25, -1, -5}, {25, 1, 8}));
  EXPECT_FALSE(v.isComplete());
  EXPECT_NEAR(v.left.volumeMm3, 650.0, 10.0);
  EXPECT_NEAR(v.left.atMm.z(), 4.0, 0.5);
}

TEST(LeftMaterial, UndercutsOfATSlotStay) {
  // Lines run along both walls of the stem.
  const geometry::TriangleMesh stem = without(kBlock, {-25, -2.56, 4}, {25, 2.62, 20});
  const CutVerdict v = milled(without(stem, {-30, -6, 4}, {30, 6, 7}));
  EXPECT_TRUE(v.passed);
  EXPECT_FALSE(v.isComplete());
  EXPECT_NEAR(v.left.volumeMm3, 40.0 * 3.0 * (12.0 - 5.18), 40.0);
  EXPECT_NEAR(v.left.thickestMm, 3.0, 0.1);
  EXPECT_NEAR(v.left.atMm.z(), 5.5, 0.1);
  EXPECT_GT(std::abs(v.left.atMm.y()), 2.5);
}

// A pocket with lines along its walls: the ball leaves fillets at them and in the four corners.
TEST(LeftMaterial, CornersAreOnlyNamed) {
  const CutVerdict v = milled(without(kBlock, {-12, -6.37, 4}, {12, 6.43, 20}));
  EXPECT_TRUE(v.isComplete()) << v.left.volumeMm3 << " at " << v.left.atMm.transpose();
  EXPECT_GT(v.left.cornersMm3, 10.0);
}

// Lines end 1.5 mm before both walls of the pocket, which have 8 mm of material then.
TEST(LeftMaterial, MaterialMissedByTheLinesAtAWallRemains) {
  const CutVerdict v = milled(without(kBlock, {-12, -6, 4}, {12, 6, 20}));
  EXPECT_FALSE(v.isComplete());
  EXPECT_GT(v.left.volumeMm3, 24.0 * 2.0 * 1.0 * 8.0);
  EXPECT_LT(v.left.volumeMm3, 24.0 * 2.0 * 1.6 * 8.0);
}

TEST(LeftMaterial, AHollowStays) {
  geometry::TriangleMesh part = kBlock;
  test::append(part, test::box({-3, -3, 4}, {3, 3, 8}), true);
  const CutVerdict v = milled(part);
  EXPECT_NEAR(v.left.volumeMm3, 6.0 * 6.0 * 4.0, 8.0);
  EXPECT_NEAR(v.left.atMm.z(), 6.0, 0.1);
}

// No contour removes the web that the sides leave in a hole.
TEST(LeftMaterial, TheWebInAHoleStays) {
  const CutVerdict v = milled(without(kBlock, {-8, -6, -5}, {8, 6, 20}));
  EXPECT_FALSE(v.isComplete());
  EXPECT_GT(v.left.volumeMm3, 16.0 * 12.0 * MillRule{}.webMm);
  EXPECT_LT(std::abs(v.left.atMm.x()), 8.0);
  EXPECT_LT(std::abs(v.left.atMm.y()), 6.0);
}

TEST(LeftMaterial, ANotchOfTheOutlineStays) {
  const CutVerdict v = milled(without(kBlock, {-1, 2, -5}, {1, 15, 20}));
  EXPECT_FALSE(v.isComplete());
  EXPECT_GT(v.left.volumeMm3, 100.0);
  EXPECT_LT(v.left.volumeMm3, 2.0 * 8.0 * 14.0 + 5.0);
  EXPECT_NEAR(v.left.atMm.x(), 0.0, 1.1);
  EXPECT_GT(v.left.atMm.y(), 1.9);
}

} // namespace
} // namespace voluta::milling
