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
    const double circle = base::kTurn * (radius + distance);
    EXPECT_NEAR(lengthOf(loops[0]), circle, 0.03 * circle);
  }
}

TEST(Outlines, EachPartHasItsOwn) {
  EXPECT_EQ(outlinesAround(discs({{{-8, 0}, 3.0}, {{8, 0}, 3.0}}), 1.0).size(), 2u);
  EXPECT_EQ(outlinesAround(discs({{{-4, 0}, 3.0}, {{4, 0}, 3.0}}), 1.5).size(), 1u);
  EXPECT_TRUE(outlinesAround(discs({}), 1.0).empty());
}

} // namespace
} // namespace voluta::milling
