// Patches divided at regions: areas in closed form, on planes and on curved layers.
#include "base/units.h"
#include "regions/region_patches.h"

#include "helpers/flat_square.h"
#include "helpers/layer_volume.h"
#include "helpers/made_solids.h"
#include "helpers/shapes.h"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace voluta::regions {
namespace {

using Eigen::Vector3d;

// Layers of 1 mm over a square of 40 mm; uneven: no plane layers.
layers::LayerStack squares(int layers, bool uneven) {
  layers::LayerStack stack;
  stack.layerCount = layers;
  for (int k = 0; k < layers; ++k) {
    layers::LevelSurface level = test::flatSquare(20.0, 1.0, k + 0.5, 1.0);
    if (uneven)
      for (Vector3d& v : level.surface.vertices)
        v.z() += 0.2 * std::sin(0.3 * v.x());
    layers::Patch patch;
    layers::setSurface(patch, std::move(level));
    patch.layer = k;
    stack.patches.push_back(std::move(patch));
  }
  return stack;
}

std::map<int, double> volumes(const layers::LayerStack& stack) {
  std::map<int, double> all;
  for (const layers::Patch& patch : stack.patches) {
    layers::LayerStack one;
    one.patches = {patch};
    all[patch.region] += test::volumeOf(one);
  }
  return all;
}

TEST(RegionPatches, AreasAreThoseOfTheBodies) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-12.0, 12.0), radius(3.0, 9.0);
  for (int i = 0; i < 20; ++i) {
    const double x = place(random), y = place(random), r = radius(random);
    const auto body = test::cylinder({x, y, -1}, {x, y, 9}, r);
    const bool fits = std::abs(x) + r < 20.0 && std::abs(y) + r < 20.0;
    for (const bool uneven : {false, true}) {
      const layers::LayerStack stack = squares(4, uneven);
      const auto of =
          volumes(dividedPatches(stack, std::vector<SettingsRegion>{{1, body}}, 1.2, {}).stack);
      EXPECT_NEAR((of.at(0) + of.at(1)) / test::volumeOf(stack), 1.0, 1e-3) << i << uneven;
      if (fits && !uneven) {
        EXPECT_NEAR(of.at(1) / (base::kPi * r * r * 4.0), 1.0, 0.01) << i;
      }
    }
  }
}

TEST(RegionPatches, TheLaterRegionHolds) {
  const std::vector<SettingsRegion> regions{{1, test::box({-10, -10, -1}, {10, 10, 9})},
                                            {2, test::box({0, -5, 1}, {15, 5, 9})}};
  const auto of = volumes(dividedPatches(squares(4, false), regions, 1.2, {}).stack);
  EXPECT_NEAR(of.at(2), 15.0 * 10.0 * 3.0, 0.1);
  EXPECT_NEAR(of.at(1), 400.0 * 4.0 - 10.0 * 10.0 * 3.0, 0.1);
  EXPECT_NEAR(of.at(0) + of.at(1) + of.at(2), 1600.0 * 4.0, 0.1);
}

// A strip too narrow for a bead is not cut off: the other side has it.
TEST(RegionPatches, NarrowStripsGoToTheOtherSide) {
  const auto nearly = std::vector<SettingsRegion>{{1, test::box({-30, -30, -1}, {19.7, 30, 9})}};
  const auto of = volumes(dividedPatches(squares(2, false), nearly, 1.2, {}).stack);
  EXPECT_EQ(of.count(0), 0u);
  EXPECT_NEAR(of.at(1), 1600.0 * 2.0, 0.1);
  const auto strip = std::vector<SettingsRegion>{{1, test::box({19.7, -30, -1}, {30, 30, 9})}};
  const auto same = volumes(dividedPatches(squares(2, false), strip, 1.2, {}).stack);
  EXPECT_EQ(same.count(1), 0u);
}

// In every other layer the region is larger by half of it all round, in the others as much smaller:
// nothing is printed twice, and nothing is left out.
TEST(RegionPatches, InterlockedRegionsReachOverTheirEdgeInTurn) {
  constexpr double kBy = 0.5 * 3.0;
  for (const double side : {10.0, 16.0}) {
    const auto divided = dividedPatches(
        squares(4, false),
        std::vector<SettingsRegion>{
            {1, test::box({-0.5 * side, -0.5 * side, -1}, {0.5 * side, 0.5 * side, 9}), 2.0 * kBy}},
        1.2, {});
    for (const layers::Patch& patch : divided.stack.patches) {
      const double own = side + (patch.layer % 2 == 0 ? 2.0 : -2.0) * kBy;
      EXPECT_NEAR(geometry::area(patch.surface), patch.region == 1 ? own * own : 1600.0 - own * own,
                  0.05)
          << patch.layer;
    }
    EXPECT_EQ(divided.stack.patches.size(), 8u);
  }
  // At the part's own surface there is nothing to reach into.
  const auto edge = dividedPatches(
      squares(2, false),
      std::vector<SettingsRegion>{{1, test::box({0, -30, -1}, {30, 30, 9}), 2.0 * kBy}}, 1.2, {});
  for (const layers::Patch& patch : edge.stack.patches)
    if (patch.region == 1) {
      EXPECT_NEAR(geometry::area(patch.surface),
                  40.0 * (20.0 + (patch.layer % 2 == 0 ? kBy : -kBy)), 0.05);
    }
}

// Layers in which a region has no effect are counted by their reason.
TEST(RegionPatches, RegionsWithoutEffectAreCounted) {
  const auto met = [](const SettingsRegion& region) {
    return dividedPatches(squares(4, false), std::vector{region}, 1.2, {}).met.at(0);
  };
  const LayersMet strip = met({1, test::box({19.7, -30, -1}, {30, 30, 9})});
  EXPECT_EQ(strip.layers, 4u);
  EXPECT_EQ(strip.narrow, 4u);
  const LayersMet crossed = met({1, test::box({-2, -10, -1}, {2, 10, 9}), 5.0});
  EXPECT_EQ(crossed.layers, 4u);
  EXPECT_EQ(crossed.crossed, 2u) << "every other layer";
  const LayersMet held = met({1, test::box({-4, -10, -1}, {4, 10, 9}), 5.0});
  EXPECT_EQ(held.layers, 4u);
  EXPECT_EQ(held.crossed + held.narrow, 0u);
  EXPECT_EQ(met({1, test::box({-9, -9, 0.8}, {9, 9, 0.85})}).layers, 0u) << "between two layers";
}

TEST(RegionPatches, SupportsAndDistantBodiesChangeNothing) {
  layers::LayerStack stack = squares(3, false);
  stack.patches[1].group = layers::kSupportGroup;
  const auto divided = dividedPatches(
      stack, std::vector<SettingsRegion>{{1, test::box({-5, -5, -1}, {5, 5, 9})}}, 1.2, {});
  int supports = 0;
  for (const layers::Patch& patch : divided.stack.patches)
    if (patch.group == layers::kSupportGroup) {
      ++supports;
      EXPECT_EQ(patch.region, 0);
      EXPECT_EQ(patch.surface.triangles, stack.patches[1].surface.triangles);
    }
  EXPECT_EQ(supports, 1);
  const auto same = dividedPatches(
      squares(3, false), std::vector<SettingsRegion>{{1, test::box({50, 50, 0}, {60, 60, 9})}}, 1.2,
      {});
  EXPECT_EQ(same.stack.patches.size(), 3u);
}

} // namespace
} // namespace voluta::regions
