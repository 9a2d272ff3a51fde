// Table 7.2 and the ridges that round cutters leave.
#include "milling/cutting_data.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta::milling {
namespace {

// A cutter of 3.175 mm with one tooth (Castelli 7.2.4).
TEST(CuttingData, IsThatOfTheSource) {
  const Cutter cutter;
  const CuttingData* hard = cuttingDataFor("hard-plastic");
  const CuttingData* soft = cuttingDataFor("soft-plastic");
  ASSERT_NE(hard, nullptr);
  ASSERT_NE(soft, nullptr);
  EXPECT_NEAR(feedMmPerMin(cutter, *soft), 323.85, 1e-9);
  EXPECT_NEAR(feedMmPerMin(cutter, *hard), 215.9, 1e-9);
  EXPECT_NEAR(lineDistanceMm(cutter, *hard), 1.5875, 1e-12);
  EXPECT_NEAR(finePassMm(cutter, *hard), 2.54, 1e-12);
  EXPECT_DOUBLE_EQ(soft->rpm, 8500.0);
  EXPECT_EQ(cuttingDataFor("steel"), nullptr);
}

TEST(Ridges, AreThoseOfCircles) {
  EXPECT_NEAR(ridgeOnPlaneMm(2.0, 2.0), 2.0 - std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(ridgeOnPlaneMm(2.0, 9.0), 2.0, 1e-12);
  // A very large sphere is a plane.
  EXPECT_NEAR(ridgeOnSphereMm(1.5, 1e6, 0.0, 1.0), ridgeOnPlaneMm(1.5, 1.0), 1e-5);
  // Further down a sphere, lines are further apart along it.
  EXPECT_GT(ridgeOnSphereMm(1.5, 15.0, 8.0, 1.0), ridgeOnSphereMm(1.5, 15.0, 0.0, 1.0));
}

} // namespace
} // namespace voluta::milling
