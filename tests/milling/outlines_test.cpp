// Curves around a silhouette.
#include "milling/contour.h"

#include "base/units.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::milling {
namespace {

using Eigen::Vector2d;

double lengthOf(const std::vector<Vector2d>& loop) {
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return length;
}

HeightMap discs(const std::vector<std::pair<Vector2d, double>>& all) {
  HeightMap map{gridOver({-20, -20}, {20, 20}, 0.1), {}, {}, {}};
  map.top.assign(map.grid.size(), HeightMap::kNone);
  for (const auto& [middle, radius] : all)
    visitAround(map.grid, middle, radius, [&](std::size_t cell, double) { map.top[cell] = 1.0; });
  return map;
}

TEST(Outlines, AroundADiscAreCircles) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int k = 0; k < 100; ++k) {
    const double radius = 2.0 + 8.0 * share(random), distance = 0.5 + 3.0 * share(random);
    const Vector2d middle(6.0 * share(random) - 3.0, 6.0 * share(random) - 3.0);
    const auto loops = outlinesAround(discs({{middle, radius}}), distance);
    ASSERT_EQ(loops.size(), 1u);
    for (const Vector2d& p : loops[0])
      EXPECT_NEAR((p - middle).norm(), radius + distance, 0.12);
    const double circle = base::kTwoPi * (radius + distance);
    EXPECT_NEAR(lengthOf(loops[0]), circle, 0.03 * circle);
  }
}

TEST(Outlines, EachPartHasItsOwn) {
  EXPECT_EQ(outlinesAround(discs({{{-8, 0}, 3.0}, {{8, 0}, 3.0}}), 1.0).size(), 2u);
  EXPECT_EQ(outlinesAround(discs({{{-4, 0}, 3.0}, {{4, 0}, 3.0}}), 1.5).size(), 1u);
  EXPECT_TRUE(outlinesAround(discs({}), 1.0).empty());
}

// The contour frees a disc except for a strip at its lower end along y, by which it stays in its
// block.
TEST(Contour, LeavesTheStripThatHoldsThePart) {
  const double radius = 8.0;
  MillRule rule;
  rule.data = *cuttingDataFor("soft-plastic");
  const auto moves = contourMoves(discs({{{2.0, 3.0}, radius}}), rule, {1.0, 0.0, 12.0});
  const double strip = 3.0 - radius + rule.stripMm;
  const double around = radius + rule.cutter.radiusMm();
  double lowest = 20.0, highest = -20.0, height = 1.0;
  for (const MillMove& move : moves) {
    if (move.step == MillStep::Rapid) {
      EXPECT_GE(move.to.z(), 12.0);
      continue;
    }
    EXPECT_NEAR((move.to.head<2>() - Vector2d(2.0, 3.0)).norm(), around, 0.12);
    lowest = std::min(lowest, move.to.y());
    highest = std::max(highest, move.to.y());
    height = std::min(height, move.to.z());
  }
  EXPECT_NEAR(lowest, strip, 0.25);
  EXPECT_NEAR(highest, 3.0 + around, 0.12);
  EXPECT_NEAR(height, -rule.cutter.radiusMm(), 1e-9);
}

} // namespace
} // namespace voluta::milling
