// Arcs in closed form, and motions that they replace.
#include "program/common/arc.h"

#include "base/units.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>

namespace voluta::program {
namespace {

using Eigen::Vector3d;

TEST(ArcOf, threePointsGiveCentreRadiusAndSweep) {
  const auto arc = arcThrough({10, 0, 5}, {0, 10, 5}, {-10, 0, 5});
  ASSERT_TRUE(arc);
  EXPECT_NEAR((arc->centre - Vector3d(0, 0, 5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(arc->radiusMm, 10.0, 1e-12);
  EXPECT_NEAR(arc->sweepRad, base::kPi, 1e-12);
  EXPECT_NEAR((arc->directionAt(0.0) - Vector3d(0, 1, 0)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(arcThrough({0, 0, 0}, {1, 0, 0}, {2, 0, 0}));
  EXPECT_FALSE(arcThrough({0, 0, 0}, {0, 0, 0}, {2, 0, 0}));
}

TEST(ArcOf, theSideOfTheAxisGivesTheSense) {
  const Vector3d from(10, 0, 0), to(0, 10, 0), zero = Vector3d::Zero();
  EXPECT_NEAR(arcAbout(zero, Vector3d::UnitZ(), from, to)->sweepRad, 0.5 * base::kPi, 1e-12);
  EXPECT_NEAR(arcAbout(zero, -Vector3d::UnitZ(), from, to)->sweepRad, 1.5 * base::kPi, 1e-12);
  EXPECT_NEAR(arcAbout(zero, Vector3d::UnitZ(), from, from)->sweepRad, 2.0 * base::kPi, 1e-12);
  EXPECT_FALSE(arcAbout(from, Vector3d::UnitZ(), from, to));
}

TEST(ArcOf, aThousandArcsComeBackFromThreeOfTheirPoints) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(unit(random), unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5)
            .normalized();
    Arc arc;
    arc.centre = 100.0 * Vector3d(unit(random), unit(random), unit(random));
    arc.u = rotation * Vector3d::UnitX();
    arc.v = rotation * Vector3d::UnitY();
    arc.radiusMm = 0.5 + 80.0 * unit(random);
    arc.sweepRad = 0.1 + 5.0 * unit(random);
    const auto found = arcThrough(arc.at(0), arc.at((0.3 + 0.4 * unit(random)) * arc.sweepRad),
                                  arc.at(arc.sweepRad));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->radiusMm, arc.radiusMm, 1e-6);
    EXPECT_NEAR(found->sweepRad, arc.sweepRad, 1e-7);
    Vector3d last = found->at(0);
    for (const Vector3d& p : pointsAlong(*found)) {
      ASSERT_LT(arc.distanceMm(p), 1e-6);
      ASSERT_LT(arc.distanceMm(0.5 * (p + last)), 6e-4);
      last = p;
    }
  }
}

} // namespace
} // namespace voluta::program
