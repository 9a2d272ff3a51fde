// Charts on their way from a level to patches.
#include "base/run_context.h"
#include "helpers/flat_square.h"
#include "helpers/rod_level.h"
#include "helpers/shapes.h"
#include "layers/absorb.h"
#include "layers/clean_surface.h"
#include "layers/follow_top.h"
#include "layers/patches.h"
#include "layers/trim.h"

#include <gtest/gtest.h>

namespace voluta::layers {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 4.0;

// Furthest that a vertex's chart is from the angle and the place where it is.
template <typename Surface> double worstChart(const Surface& s, const geometry::TriangleMesh& m) {
  double worst = 0.0;
  for (std::size_t v = 0; v < m.vertices.size(); ++v) {
    const Vector3d& p = m.vertices[v];
    const double u = kRadius * std::atan2(p.z(), p.y());
    worst = std::max({worst, std::abs(std::remainder(s.chart.at[v].x() - u, s.chart.periodMm)),
                      std::abs(s.chart.at[v].y() - p.x())});
  }
  return worst;
}

TEST(Chart, DifferencesAndBlendsTakeTheShortWayRound) {
  Chart c;
  c.periodMm = 10.0;
  c.at = {{4.5, 0.0}, {-4.5, 2.0}, {-3.5, 1.0}};
  EXPECT_NEAR((c.between(0, 1) - Eigen::Vector2d(1.0, 2.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((c.blend(0, 1, 0.25) - Eigen::Vector2d(4.75, 0.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((c.blend({0, 1, 2}, {0.5, 0.25, 0.25}) - Eigen::Vector2d(5.25, 0.75)).norm(), 0.0,
              1e-12);
  c.periodMm = 0.0;
  EXPECT_NEAR((c.between(0, 1) - Eigen::Vector2d(-9.0, 2.0)).norm(), 0.0, 1e-12);
}

TEST(Chart, StaysRightThroughCuttingCleaningAndFollowingTheTop) {
  // Three quarters of the level's ends and its seam at -pi are in the part, whose top is 0.05 mm
  // over the level.
  const auto part = test::box({-7.3, -9, -9}, {7.3, 0, 4.05});
  const PartBoundary boundary(part, 0.3, {});
  LevelSurface s = trimToPart(test::rodLevel(kRadius, -12, 12, 0.3, 0.25), boundary, {}, {});
  ASSERT_EQ(s.chart.at.size(), s.surface.vertices.size());
  EXPECT_LT(worstChart(s, s.surface), 1e-4);
  cleanSurface(s, {}, {});
  ASSERT_EQ(s.chart.at.size(), s.surface.vertices.size());
  LayerStack stack;
  stack.layerCount = 1;
  stack.patches = makePatches(s, {0.7}).patches;
  ASSERT_EQ(stack.patches.size(), 1u);
  Patch& patch = stack.patches[0];
  ASSERT_EQ(patch.chart.at.size(), patch.surface.vertices.size());
  EXPECT_EQ(patch.chart.periodMm, s.chart.periodMm);
  const std::size_t before = patch.surface.vertices.size();
  TopOptions top;
  top.heightMinMm = 0.1;
  top.heightMaxMm = 0.6;
  top.fineMm = 0.05;
  followTop(stack, boundary, top, {});
  ASSERT_EQ(patch.chart.at.size(), patch.surface.vertices.size());
  EXPECT_GT(patch.surface.vertices.size(), before); // edges were split
  EXPECT_LT(*std::ranges::min_element(patch.thicknessMm), 0.2);
  EXPECT_LT(worstChart(patch, patch.surface), 1e-4);
}

TEST(Chart, ALevelWithoutOneGivesPatchesWithoutOne) {
  const auto part = test::box({-7, -4.2, -5}, {7, 4.2, 5});
  const PartBoundary boundary(part, 0.8, {});
  LevelSurface s = trimToPart(test::flatSquare(9.8, 0.7, 0.2), boundary, {}, {});
  cleanSurface(s, {}, {});
  for (const Patch& p : makePatches(s, {}).patches)
    EXPECT_TRUE(p.chart.empty());
}

} // namespace
} // namespace voluta::layers
