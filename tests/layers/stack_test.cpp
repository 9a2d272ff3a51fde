// Whole stacks before the tests' own checker: its results for good ones, the faults it finds, and
// levels beyond the height limits.
#include "base/run_context.h"
#include "curved/curved_layers.h"
#include "geometry/measures.h"
#include "helpers/flat_square.h"
#include "layers/absorb.h"
#include "layers/islands.h"
#include "layers/layer_checks.h"
#include "layers/level_surface.h"
#include "layers/order.h"
#include "layers/stack_checker.h"
#include "synthetic.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace voluta {
namespace {

using Eigen::Vector3d;
using test::flatSquare;

constexpr double kMin = 0.4, kMax = 1.0;

geometry::TriangleMesh block() {
  return test::box({-15, -10, 0}, {15, 10, 20});
}

curved::LayersResult layersOf(const geometry::TriangleMesh& part,
                              const test::FieldFunction& field) {
  const auto d = test::decompositionOf(part, 0.8, field);
  return curved::curvedLayers(d, part, {0.8, kMin, kMax, 1.2, false}, base::RunContext({}, 2));
}

test::StackVerdict check(const layers::LayerStack& stack) {
  return test::checkStack(stack, block(), kMin, kMax);
}

TEST(StackChecker, FindsNoFaultInFlatLayers) {
  const auto r = layersOf(block(), [](const Vector3d& p) { return p.z(); });
  const auto v = check(r.stack);
  EXPECT_NEAR(v.volumeRatio, 1.0, 1e-3);
  EXPECT_LE(v.boundaryFarthestMm, 1e-3);
  EXPECT_EQ(v.looseVertices + v.nearVertices, 0u);
  EXPECT_EQ(v.seamVertices, 0u);
  EXPECT_EQ(v.notSimple, 0u);
  EXPECT_NEAR(v.thicknessMeanMm, 0.8, 1e-3);
  EXPECT_GT(v.within, 0.9999);
  EXPECT_GT(v.asReported, 0.9999);
  EXPECT_EQ(v.unsupported, 0.0);
  EXPECT_EQ(v.patchesInTheAir, 0u);
  EXPECT_TRUE(v.layersRise);
  EXPECT_LT(v.inNone, 0.002);
  EXPECT_LT(v.inSeveral, 0.002);
  EXPECT_EQ(v.sharpCrossings, 4 * r.stack.patches.size());
  EXPECT_LT(v.sharpOffMaxMm, 5e-3); // as far as cleaning may move a boundary
}

TEST(StackChecker, SeesFaults) {
  const auto good = layersOf(block(), [](const Vector3d& p) { return p.z(); }).stack;
  {
    layers::LayerStack s = good;
    for (double& t : s.patches[10].thicknessMm)
      t *= 1.5;
    EXPECT_GT(check(s).volumeRatio, 1.01);
    EXPECT_GT(check(s).inSeveral, 0.005);
    EXPECT_LT(check(s).asReported, 0.98);
  }
  {
    layers::LayerStack s = good;
    s.patches.erase(s.patches.begin() + 10);
    const auto v = check(s);
    EXPECT_LT(v.volumeRatio, 0.97);
    EXPECT_GT(v.inNone, 0.02);
    EXPECT_EQ(v.patchesInTheAir, 1u);
    EXPECT_FALSE(v.layersRise);
  }
  {
    layers::LayerStack s = good;
    std::swap(s.patches[10], s.patches[11]);
    std::swap(s.patches[10].layer, s.patches[11].layer);
    EXPECT_EQ(check(s).outOfOrder, 1u);
  }
  {
    layers::LayerStack s = good;
    for (Vector3d& v : s.patches[10].surface.vertices)
      v.x() *= 1.001;
    const auto v = check(s);
    EXPECT_GT(v.nearVertices, 10u);
  }
  {
    layers::LayerStack s = good;
    for (Vector3d& v : s.patches[10].surface.vertices)
      v.head<2>() *= 0.9;
    EXPECT_GT(check(s).looseVertices, 10u);
  }
  {
    layers::LayerStack s = good;
    s.patches[10].surface.triangles.push_back(s.patches[10].surface.triangles.front());
    EXPECT_EQ(check(s).notSimple, 1u);
  }
}

TEST(PartialLevels, SplitThickLayersAndJoinThinOnes) {
  struct Case {
    double slope, expected;
  };
  for (const Case& c : {Case{0.56, 0.714}, Case{0.3, 0.667}, Case{2.5, 0.64}, Case{2.9, 0.552}}) {
    const auto r = layersOf(block(), [&](const Vector3d& p) { return c.slope * p.z(); });
    const auto v = check(r.stack);
    EXPECT_GT(v.within, 0.9995) << c.slope;
    EXPECT_NEAR(r.statistics.withinLimitsFraction, 1.0, 1e-9) << c.slope;
    EXPECT_NEAR(v.thicknessMeanMm, c.expected, 0.01) << c.slope;
    EXPECT_NEAR(v.volumeRatio, 1.0, 0.02) << c.slope; // flat tops end within a layer
    EXPECT_LT(v.unsupported, 1e-4) << c.slope;
    EXPECT_TRUE(v.layersRise);
  }
}

TEST(PartialLevels, ConserveVolumeWhereTheyMeetWholeOnes) {
  // Thickness rises along x from 0.32 to 1.3 mm: joined, whole and halved levels side by side.
  const auto r = layersOf(
      block(), [](const Vector3d& p) { return p.z() * 0.8 / (0.81 + p.x() / 15.0 * 0.49); });
  const auto v = check(r.stack);
  EXPECT_GT(r.partialPatches, 10u);
  EXPECT_GT(r.partialAreaMm2, 0.2 * r.statistics.areaMm2);
  EXPECT_NEAR(v.volumeRatio, 1.0, 0.01);
  EXPECT_GT(v.within, 0.98);
  EXPECT_GT(r.statistics.withinLimitsFraction, 0.98);
  EXPECT_LT(v.inNone, 0.03);
  EXPECT_LT(v.inSeveral, 0.03);
  EXPECT_GT(v.seamVertices, 100u);
  std::size_t onSeams = 0;
  for (const layers::Patch& patch : r.stack.patches) {
    ASSERT_TRUE(patch.innerRim.empty() || patch.innerRim.size() == patch.thicknessMm.size());
    onSeams += static_cast<std::size_t>(std::ranges::count(patch.innerRim, 1));
  }
  EXPECT_GT(onSeams, 100u);
  EXPECT_EQ(v.looseVertices, 0u);
  EXPECT_EQ(v.notSimple, 0u);
  EXPECT_EQ(v.patchesInTheAir, 0u);
  EXPECT_EQ(v.outOfOrder, 0u);
  EXPECT_TRUE(v.layersRise);
  EXPECT_LE(r.boundaryFarthestMm, 1e-3);
}

TEST(PartialLevels, LeaveASmallPlaceAsItIs) {
  // A dent of 1 mm in which levels would be too thick.
  const auto r = layersOf(block(), [](const Vector3d& p) {
    const double far = (p - Vector3d(0, 0, 10)).norm();
    return p.z() - 0.5 * std::exp(-far * far / 0.5) * (p.z() - 10.0);
  });
  EXPECT_EQ(r.partialPatches, 0u);
}

layers::Patch patchOf(const layers::LevelSurface& s, int layer) {
  layers::Patch p;
  p.surface = s.surface;
  p.thicknessMm = s.thicknessMm;
  p.direction = s.direction;
  p.clearDirection = s.clearDirection;
  p.layer = layer;
  return p;
}

TEST(KeepPositive, CutsAlongTheZeroLineAndMarksIt) {
  layers::LevelSurface s = flatSquare(5, 0.5, 1.0, 0.8);
  std::vector<double> values;
  for (const Vector3d& v : s.surface.vertices)
    values.push_back(1.7 - v.x() - 0.5 * v.y());
  layers::keepPositive(s, values);
  double area = 0.0; // of the square's part below the line, by rows
  for (int k = 0; k < 1000; ++k)
    area += std::clamp(1.7 - 0.5 * (-5 + (k + 0.5) * 0.01) + 5, 0.0, 10.0) * 0.01;
  EXPECT_NEAR(geometry::area(s.surface), area, 1e-2);
  std::size_t marked = 0;
  ASSERT_EQ(s.innerRim.size(), s.surface.vertices.size());
  for (std::size_t v = 0; v < s.innerRim.size(); ++v) {
    const Vector3d& p = s.surface.vertices[v];
    const double value = 1.7 - p.x() - 0.5 * p.y();
    EXPECT_GE(value, -1e-9);
    EXPECT_EQ(s.innerRim[v] != 0, std::abs(value) < 1e-9);
    marked += s.innerRim[v];
  }
  EXPECT_GT(marked, 20u);
}

TEST(AbsorbSlivers, GivesTheirVolumeToThePatchBelow) {
  std::vector<layers::Patch> patches{patchOf(flatSquare(5, 0.5, 1.0, 0.7), 1)};
  const auto sliver = patchOf(flatSquare(0.4, 0.2, 1.6, 0.5), 2);
  const auto volumeOf = [&] {
    layers::LayerStack s;
    s.patches = patches;
    return layers::layerStatistics(s).volumeMm3();
  };
  const double before = volumeOf();
  const auto a = layers::absorbSlivers(patches, {sliver}, {1.0, 1.2});
  EXPECT_EQ(a.merged, 1u);
  EXPECT_TRUE(a.dropped.empty());
  EXPECT_NEAR(a.mergedVolumeMm3, 0.64 * 0.5, 1e-9);
  EXPECT_NEAR(volumeOf() - before, 0.64 * 0.5, 0.03); // a bump has more area than its floor
  for (std::size_t v = 0; v < patches[0].thicknessMm.size(); ++v) {
    EXPECT_LE(patches[0].thicknessMm[v], 1.0);
    // Its foot stays where it was.
    EXPECT_NEAR(patches[0].surface.vertices[v].z() - 0.5 * patches[0].thicknessMm[v], 0.65, 1e-12);
  }
}

TEST(AbsorbSlivers, DropsSliversWithoutRoom) {
  std::vector<layers::Patch> patches{patchOf(flatSquare(5, 0.5, 1.0, 0.98), 1)};
  const auto sliver = patchOf(flatSquare(0.4, 0.2, 1.7, 0.5), 2);
  const auto far = patchOf(flatSquare(0.4, 0.2, 9.0, 0.5), 3);
  const auto a = layers::absorbSlivers(patches, {sliver, far}, {1.0, 1.2});
  EXPECT_EQ(a.merged, 0u);
  ASSERT_EQ(a.dropped.size(), 2u);
  EXPECT_NEAR(a.dropped[0].volumeMm3 + a.mergedVolumeMm3, 0.64 * 0.5, 1e-9);
  EXPECT_GT(a.dropped[0].volumeMm3, 0.2);
  EXPECT_NEAR(a.dropped[1].volumeMm3, 0.64 * 0.5, 1e-9);
  EXPECT_NEAR(a.dropped[1].centre.z(), 9.0, 1e-9);
}

TEST(AbsorbIslands, SupportsAnIslandByThePatchOverIt) {
  layers::LayerStack s;
  for (int layer = 0; layer < 4; ++layer)
    s.patches.push_back(patchOf(flatSquare(4, 0.5, 0.3 + 0.6 * layer, 0.6), layer));
  auto island = flatSquare(3, 0.3, 0.3 + 0.6 * 3, 0.6); // 36 mm2, 4.5 mm beside the column
  for (auto& v : island.surface.vertices)
    v.x() += 11.5;
  s.patches.push_back(patchOf(std::move(island), 3));
  s.patches.push_back(patchOf(flatSquare(15, 0.5, 0.3 + 0.6 * 4, 0.6), 4)); // rests on both
  layers::orderForPrinting(s);
  const double before = layers::layerStatistics(s).volumeMm3();
  const auto taken = layers::absorbIslands(s, {}, {1.0, 1.2}, {});
  EXPECT_EQ(s.patches.size(), 5u);
  EXPECT_GT(taken.absorbed.mergedVolumeMm3, 0.7 * 36 * 0.6);
  ASSERT_EQ(taken.support.size(), s.patches.size());
  for (const auto& support : taken.support)
    EXPECT_GT(support.supportedFraction, 0.02);
  double dropped = 0.0;
  for (const auto& piece : taken.absorbed.dropped)
    dropped += piece.volumeMm3;
  EXPECT_NEAR(layers::layerStatistics(s).volumeMm3() + dropped, before, 0.01 * before);
  for (const auto& patch : s.patches)
    for (double t : patch.thicknessMm)
      EXPECT_LE(t, 1.0);
}

TEST(AbsorbIslands, LeavesLargeOnesThatFindNoRoomAndDropsSmallOnes) {
  for (const double half : {6.0, 1.2}) {
    layers::LayerStack s;
    s.patches.push_back(patchOf(flatSquare(8, 1.0, 0.3, 0.6), 0));
    s.patches.push_back(patchOf(flatSquare(half, 0.3, 5.0, 0.6), 1));
    layers::orderForPrinting(s);
    const auto taken = layers::absorbIslands(s, {}, {1.0, 1.2}, {});
    EXPECT_EQ(s.patches.size(), half > 3.0 ? 2u : 1u);
    EXPECT_EQ(taken.absorbed.dropped.size(), half > 3.0 ? 0u : 1u);
    EXPECT_EQ(s.layerCount, static_cast<int>(s.patches.size()));
    EXPECT_EQ(taken.support.back().supportedFraction<0.02, half> 3.0);
  }
}

TEST(AbsorbIslands, LeaveSupportAlone) {
  layers::LayerStack s;
  s.patches.push_back(patchOf(flatSquare(8, 1.0, 0.3, 0.6), 0));
  s.patches.push_back(patchOf(flatSquare(1.0, 0.3, 5.0, 0.6), 1));
  s.patches.back().group = layers::kSupportGroup;
  const auto taken = layers::absorbIslands(s, {}, {1.0, 1.2}, {});
  EXPECT_EQ(s.patches.size(), 2u);
  EXPECT_TRUE(taken.absorbed.dropped.empty());
}

TEST(OrderForPrinting, NumbersLayersWithoutGaps) {
  layers::LayerStack s;
  for (int layer : {12, 4, 8, 4, 10})
    s.patches.push_back(patchOf(flatSquare(1, 1, layer, 0.8), layer));
  layers::orderForPrinting(s);
  EXPECT_EQ(s.layerCount, 4);
  const std::vector<int> wanted{0, 0, 1, 2, 3};
  for (std::size_t p = 0; p < wanted.size(); ++p)
    EXPECT_EQ(s.patches[p].layer, wanted[p]);
}

} // namespace
} // namespace voluta
