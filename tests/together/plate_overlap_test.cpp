// Plates of two cells beside and in each other, against closed forms.
#include "together/plate_overlap.h"

#include "base/units.h"
#include "process/process.h"
#include "robot/cell.h"
#include "robot/plate.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta::together {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

robot::Cell cellWithPlate(const char* id = "ur5-moving") {
  return robot::loadCell(id, process::loadProcess("fdm-1.0"),
                         {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}});
}

Isometry3d at(double x, double y, double z = 0.0) {
  return Isometry3d(Eigen::Translation3d(x, y, z));
}

TEST(PlateOverlap, IsTheSharedStripOfPlatesSideBySide) {
  const robot::Cell cell = cellWithPlate();
  const auto overlap = [&](const Isometry3d& place) {
    return plateOverlap({cell, at(30, 40)}, {cell, at(30, 40) * place});
  };
  EXPECT_FALSE(overlap(at(200, 0))) << "they meet";
  EXPECT_FALSE(overlap(at(250, 0)));
  const auto strip = overlap(at(180, 50));
  ASSERT_TRUE(strip);
  EXPECT_NEAR(strip->depthMm, 20.0, 1e-6);
  EXPECT_NEAR(strip->areaMm2, 20.0 * 150.0, 1e-6);
  const auto same = overlap(at(0, 0));
  ASSERT_TRUE(same);
  EXPECT_NEAR(same->depthMm, 200.0, 1e-6);
  EXPECT_NEAR(same->areaMm2, 40000.0, 1e-6);
  const robot::Prism* plate = robot::plateOf(cell);
  ASSERT_NE(plate, nullptr);
  const double thick = plate->zMax - plate->zMin;
  EXPECT_TRUE(overlap(at(0, 0, 0.5 * thick)));
  EXPECT_FALSE(overlap(at(0, 0, 1.1 * thick))) << "above each other";
}

// A corner in the middle of a side: a triangle, and half of the square's diagonal deep.
TEST(PlateOverlap, OfAPlateTurnedByAnEighth) {
  const robot::Cell cell = cellWithPlate();
  const Vector3d middle = cell.base_T_work(cell.home()).translation();
  Isometry3d turned = Isometry3d::Identity();
  turned.linear() = Eigen::AngleAxisd(0.25 * base::kPi, Vector3d::UnitZ()).toRotationMatrix();
  // About the plate's middle, and then so far that its corner is 30 mm within the side.
  turned.translation() =
      middle - turned.linear() * middle + Vector3d(100.0 * std::sqrt(2.0) + 70.0, 0.0, 0.0);
  const auto corner = plateOverlap({cell, at(0, 0)}, {cell, turned});
  ASSERT_TRUE(corner);
  EXPECT_NEAR(corner->depthMm, 30.0, 1e-6);
  EXPECT_NEAR(corner->areaMm2, 900.0, 1e-6);
}

TEST(PlateOverlap, IsNoneOfPlatesThatAnArmCarries) {
  const robot::Cell fixed = cellWithPlate("ur5-fixed"), moving = cellWithPlate();
  EXPECT_FALSE(plateOverlap({fixed, at(0, 0)}, {fixed, at(0, 0)}));
  EXPECT_FALSE(plateOverlap({moving, at(0, 0)}, {fixed, at(0, 0)}));
}

} // namespace
} // namespace voluta::together
