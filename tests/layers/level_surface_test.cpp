// Vertices between others, and vertices that no triangle uses.
#include "layers/level_surface.h"

#include "layers/layer_findings.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::layers {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

// Two triangles, of which each vertex has values of its own.
LevelSurface quad() {
  LevelSurface s;
  s.surface.vertices = {{0, 0, 0}, {4, 0, 1}, {4, 2, 3}, {0, 2, 2}, {9, 9, 9}};
  s.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.thicknessMm = {0.4, 0.8, 1.0, 0.6, 5.0};
  for (int k = 0; k < 5; ++k) {
    s.direction.emplace_back(std::sin(0.2 * k), 0.0, std::cos(0.2 * k));
    s.clearDirection.emplace_back(0.0, std::sin(0.1 * k), std::cos(0.1 * k));
  }
  s.innerRim = {1, 1, 0, 1, 1};
  s.chart.periodMm = 10.0;
  s.chart.at = {{4.0, 0.0}, {-4.0, 2.0}, {-3.0, 4.0}, {4.5, 6.0}, {0.0, 0.0}};
  return s;
}

TEST(LevelSurface, AVertexOnAnEdgeIsBetweenItsEnds) {
  for (const double t : {0.0, 0.25, 0.8, 1.0}) {
    LevelSurface s = quad();
    const int v = appendBlend(s, 0, 1, t);
    ASSERT_EQ(v, 5);
    EXPECT_LT((s.surface.vertices[5] - Vector3d(4 * t, 0, t)).norm(), 1e-12);
    EXPECT_NEAR(s.thicknessMm[5], 0.4 + 0.4 * t, 1e-12);
    const Vector3d d = (1 - t) * s.direction[0] + t * s.direction[1];
    const Vector3d c = (1 - t) * s.clearDirection[0] + t * s.clearDirection[1];
    EXPECT_LT((s.direction[5] - d.normalized()).norm(), 1e-12);
    EXPECT_LT((s.clearDirection[5] - c.normalized()).norm(), 1e-12);
    // Round the short way: from 4 over 5 to 6.
    EXPECT_LT((s.chart.at[5] - Vector2d(4 + 2 * t, 2 * t)).norm(), 1e-12);
    EXPECT_EQ(s.innerRim[5], 1);
    appendBlend(s, 0, 2, t);
    EXPECT_EQ(s.innerRim[6], 0) << "one of its ends is on no inner rim";
  }
  // Directions that cancel: that of the first.
  LevelSurface s = quad();
  s.direction[1] = -s.direction[0];
  s.clearDirection[1] = -s.clearDirection[0];
  appendBlend(s, 0, 1, 0.5);
  EXPECT_EQ(s.direction[5], s.direction[0]);
  EXPECT_EQ(s.clearDirection[5], s.clearDirection[0]);
}

TEST(LevelSurface, AVertexInATriangleHasItsCornersShares) {
  LevelSurface s = quad();
  const Vector3d weights(0.5, 0.3, 0.2), place(7, 8, 9);
  const int v = appendBlend(s, {3, 1, 2}, weights, place);
  ASSERT_EQ(v, 5);
  EXPECT_EQ(s.surface.vertices[5], place);
  EXPECT_NEAR(s.thicknessMm[5], 0.5 * 0.6 + 0.3 * 0.8 + 0.2 * 1.0, 1e-12);
  const Vector3d d = 0.5 * s.direction[3] + 0.3 * s.direction[1] + 0.2 * s.direction[2];
  const Vector3d c =
      0.5 * s.clearDirection[3] + 0.3 * s.clearDirection[1] + 0.2 * s.clearDirection[2];
  EXPECT_LT((s.direction[5] - d.normalized()).norm(), 1e-12);
  EXPECT_LT((s.clearDirection[5] - c.normalized()).norm(), 1e-12);
  // From 4.5 by 1.5 to -4 + 10 and by 2.5 to -3 + 10.
  EXPECT_LT(
      (s.chart.at[5] - Vector2d(4.5 + 0.3 * 1.5 + 0.2 * 2.5, 0.5 * 6 + 0.3 * 2 + 0.2 * 4)).norm(),
      1e-12);
  EXPECT_EQ(s.innerRim[5], 0);
}

TEST(LevelSurface, UnusedVerticesAreDroppedAndOthersKeepTheirValues) {
  LevelSurface s = quad();
  s.surface.triangles = {{4, 2, 3}};
  const LevelSurface before = s;
  dropUnusedVertices(s);
  const std::size_t kept[] = {2, 3, 4};
  ASSERT_EQ(s.surface.vertices.size(), 3u);
  ASSERT_EQ(s.thicknessMm.size(), 3u);
  ASSERT_EQ(s.direction.size(), 3u);
  ASSERT_EQ(s.clearDirection.size(), 3u);
  ASSERT_EQ(s.innerRim.size(), 3u);
  ASSERT_EQ(s.chart.at.size(), 3u);
  EXPECT_EQ(s.surface.triangles[0], (std::array<int, 3>{2, 0, 1}));
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_EQ(s.surface.vertices[v], before.surface.vertices[kept[v]]);
    EXPECT_EQ(s.thicknessMm[v], before.thicknessMm[kept[v]]);
    EXPECT_EQ(s.direction[v], before.direction[kept[v]]);
    EXPECT_EQ(s.clearDirection[v], before.clearDirection[kept[v]]);
    EXPECT_EQ(s.innerRim[v], before.innerRim[kept[v]]);
    EXPECT_EQ(s.chart.at[v], before.chart.at[kept[v]]);
  }
}

// By which corners have values below nothing: each of the eight ways keeps its share of a triangle,
// its side up.
TEST(LevelSurface, KeepPositiveCutsEveryTriangleAtZero) {
  for (int set = 0; set < 8; ++set) {
    LevelSurface s;
    s.surface.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    s.surface.triangles = {{0, 1, 2}};
    s.thicknessMm.assign(3, 0.5);
    s.direction.assign(3, Vector3d::UnitZ());
    s.clearDirection = s.direction;
    std::vector<double> values;
    for (int k = 0; k < 3; ++k)
      values.push_back(set & (1 << k) ? 1.0 : -2.0);
    keepPositive(s, values);
    double area = 0.0;
    for (const auto& t : s.surface.triangles) {
      const auto p = [&](int k) {
        return s.surface.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
      };
      const double twice = (p(1) - p(0)).cross(p(2) - p(0)).z();
      EXPECT_GT(twice, 0.0);
      area += 0.5 * twice;
    }
    // A positive corner keeps a third of both edges to the others.
    const int count = __builtin_popcount(static_cast<unsigned>(set));
    const double share[] = {0.0, 1.0 / 9.0, 1.0 - 4.0 / 9.0, 1.0};
    EXPECT_NEAR(area, 4.5 * share[count], 1e-9) << set;
    std::size_t rim = 0;
    for (const auto r : s.innerRim)
      rim += r;
    EXPECT_EQ(rim, count == 1 || count == 2 ? 2u : 0u);
  }
}

TEST(LayerFindings, UnprintedSliversAreCountedAndBlockFromAShareOn) {
  EXPECT_EQ(notPrinted({}).pieces, 0u);
  EXPECT_FALSE(sliversFinding(notPrinted({}), 100.0, 0.01));
  const NotPrinted lost =
      notPrinted({{{1, 0, 0}, 2.0, 0.3, 1}, {{2, 0, 0}, 1.0, 0.9, 2}, {{3, 0, 0}, 9.0, 0.8, 3}});
  EXPECT_EQ(lost.pieces, 3u);
  EXPECT_NEAR(lost.volumeMm3, 2.0, 1e-12);
  EXPECT_EQ(lost.largestAt, Vector3d(2, 0, 0));
  for (const double deposited : {100.0, 300.0}) { // 2 of 102, 2 of 302
    const auto finding = sliversFinding(lost, deposited, 0.01);
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->blocking, deposited < 198.0);
    ASSERT_TRUE(finding->where);
    EXPECT_EQ(*finding->where, Vector3d(2, 0, 0));
    EXPECT_EQ(finding->count, 3u);
  }
}

TEST(LayerFindings, PatchesOnNothingAreCounted) {
  IslandOptions options;
  options.supportedShare = 0.1;
  const InAir in = patchesInAir(
      {{1.0, -1, {1, 1, 1}}, {0.05, 0, {2, 2, 2}}, {0.11, 0, {3, 3, 3}}, {0.0, -1, {4, 4, 4}}},
      options);
  EXPECT_EQ(in.patches, 2u);
  EXPECT_EQ(in.firstAt, Vector3d(2, 2, 2));
}

} // namespace
} // namespace voluta::layers
