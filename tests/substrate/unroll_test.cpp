#include "base/units.h"
#include "substrate/unroll.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta {
namespace {

TEST(Unroll, QuarterTurnIsAQuarterOfTheGirth) {
  const auto p = substrate::unroll({7, 0, 5});
  EXPECT_NEAR(p.aroundMm, 5 * base::kPi / 2, 1e-14);
  EXPECT_DOUBLE_EQ(p.alongMm, 7);
  EXPECT_DOUBLE_EQ(p.radiusMm, 5);
}

TEST(Unroll, RollsBack) {
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(-4, -2, 1e-3), Eigen::Vector3d(0, -3, -3)})
    EXPECT_NEAR((substrate::roll(substrate::unroll(p)) - p).norm(), 0.0, 1e-14);
}

TEST(Unroll, StraightLineIsTheShortestWay) {
  // A helix of half a turn at r 5 over 12 mm: as long as the diagonal of the unrolled rectangle.
  double length = 0.0;
  Eigen::Vector3d last = substrate::roll({0, 0, 5});
  for (int i = 1; i <= 20000; ++i) {
    const double t = i / 20000.0;
    const Eigen::Vector3d p = substrate::roll({t * 5 * base::kPi, t * 12, 5});
    length += (p - last).norm();
    last = p;
  }
  EXPECT_NEAR(length, std::hypot(5 * base::kPi, 12), 1e-6);
}

TEST(Unroll, WaveIsFlattened) {
  const auto wave = [](double x) { return std::cos(0.5 * x); };
  const auto height = [&](double x, double z) { return substrate::flattened({x, z}, wave).y(); };
  EXPECT_NEAR(height(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(height(base::kPi, 1.5), 2.5, 1e-12);
  EXPECT_NEAR(height(0.5, 8), 8.0311, 1e-4);
  EXPECT_EQ(substrate::flattened({0.5, 8}, wave).x(), 0.5);
}

TEST(Unroll, ArcLengthOfTheWave) {
  const double length =
      substrate::arcLength([](double t) { return -0.5 * std::sin(0.5 * t); }, 0, 8 * base::kPi);
  EXPECT_NEAR(length, 26.6367, 1e-4);
  EXPECT_NEAR(length, 26.63666889, 1e-8);
  EXPECT_NEAR(substrate::arcLength([](double) { return 0.75; }, 0, 4), 5.0, 1e-12);
}

} // namespace
} // namespace voluta
