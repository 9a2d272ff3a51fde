// The direction in which infill bridges gaps, where the best one is known.
#include "toolpath/unsupported/bridge_direction.h"

#include "base/run_context.h"
#include "base/units.h"
#include "toolpath/patch_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;
using test::Loop;

process::Process processThatBridges(double mm) {
  process::Process process;
  process.bridgeMm = mm;
  process.material.bridges.clear();
  return process;
}

// A rectangle, turned about the origin; counter-clockwise.
Loop turned(double x0, double y0, double x1, double y1, double degrees) {
  const Eigen::Rotation2Dd rotation(base::degreesToRadians(degrees));
  Loop loop;
  for (const Vector2d& p : {Vector2d(x0, y0), Vector2d(x1, y0), Vector2d(x1, y1), Vector2d(x0, y1)})
    loop.push_back(rotation * p);
  return loop;
}

layers::Patch levelPatch(const std::vector<Loop>& loops, double z) {
  return test::patchOver(loops, 1.5, [z](const Vector2d& p) { return Vector3d(p.x(), p.y(), z); });
}

std::vector<const layers::Patch*> patchesOf(const layers::LayerStack& stack) {
  std::vector<const layers::Patch*> patches;
  for (const layers::Patch& patch : stack.patches)
    patches.push_back(&patch);
  return patches;
}

// Of `above` over other patches; two walls are around its infill.
std::optional<double> directionOver(const std::vector<layers::Patch>& below, layers::Patch above,
                                    double bridgeMm, double usualDeg) {
  layers::LayerStack stack{below, 2};
  stack.patches.push_back(std::move(above));
  return toolpath::bridgeDirections(
             patchesOf(stack), stack, [&](std::size_t) { return processThatBridges(bridgeMm); },
             {usualDeg, 0.0, 2}, base::RunContext())
      .back();
}

// Of a deck of 40 x 16 mm over two piers with `gapMm` between them, all turned.
std::optional<double> deckDirection(double gapMm, double bridgeMm, double degrees,
                                    double usualDeg) {
  return directionOver({levelPatch({turned(-20, -8, -0.5 * gapMm, 8, degrees)}, 0.4),
                        levelPatch({turned(0.5 * gapMm, -8, 20, 8, degrees)}, 0.4)},
                       levelPatch({turned(-20, -8, 20, 8, degrees)}, 1.2), bridgeMm, usualDeg);
}

double offDeg(double radians, double degrees) {
  return std::abs(std::remainder(base::radiansToDegrees(radians) - degrees, 180.0));
}

} // namespace

TEST(BridgeDirection, CrossesAGapBetweenPiersStraight) {
  for (const double degrees : {0.0, 20.0, 37.0, 90.0, 135.0, 171.0}) {
    SCOPED_TRACE(degrees);
    const auto direction = deckDirection(6.0, 7.0, degrees, degrees + 45.0);
    ASSERT_TRUE(direction.has_value());
    EXPECT_LE(offDeg(*direction, degrees), 10.0);
    EXPECT_FALSE(deckDirection(6.0, 7.0, degrees, degrees).has_value()) << "as good as it gets";
  }
}

TEST(BridgeDirection, StaysWithoutAGap) {
  EXPECT_FALSE(deckDirection(0.0, 7.0, 0.0, 45.0).has_value());
  EXPECT_FALSE(deckDirection(0.5, 7.0, 0.0, 45.0).has_value()) << "narrower than a bead";
}

// No direction is held over a gap that is wider than the material bridges.
TEST(BridgeDirection, StaysWhereNothingBridges) {
  EXPECT_FALSE(deckDirection(12.0, 7.0, 0.0, 90.0).has_value());
}

// A slot in a floor: across it, whichever way the usual lines run.
TEST(BridgeDirection, CrossesASlot) {
  const Loop outline = turned(-15, -15, 15, 15, 0.0);
  Loop slot = turned(-2, -10, 2, 10, 0.0);
  std::reverse(slot.begin(), slot.end());
  const auto direction =
      directionOver({levelPatch({outline, slot}, 0.4)}, levelPatch({outline}, 1.2), 5.0, 90.0);
  ASSERT_TRUE(direction.has_value());
  EXPECT_LE(offDeg(*direction, 0.0), 40.0); // 4 mm across; 5 mm may be bridged
}

// The layers of a stack are found by their heights: only the deck's first layer lies over a gap.
TEST(BridgeDirection, ConcernsTheLayerOverTheGapOnly) {
  layers::LayerStack stack;
  const auto add = [&](layers::Patch patch, int layer) {
    patch.layer = layer;
    stack.patches.push_back(std::move(patch));
    stack.layerCount = layer + 1;
  };
  for (int layer = 0; layer < 3; ++layer) {
    add(levelPatch({turned(-20, -8, -3, 8, 0)}, 0.4 + 0.8 * layer), layer);
    add(levelPatch({turned(3, -8, 20, 8, 0)}, 0.4 + 0.8 * layer), layer);
  }
  for (int layer = 3; layer < 5; ++layer)
    add(levelPatch({turned(-20, -8, 20, 8, 0)}, 0.4 + 0.8 * layer), layer);
  const auto directions = toolpath::bridgeDirections(
      patchesOf(stack), stack, [](std::size_t) { return processThatBridges(7.0); },
      {135.0, 90.0, 2}, base::RunContext());
  ASSERT_EQ(directions.size(), 8u);
  for (std::size_t i = 0; i < directions.size(); ++i)
    EXPECT_EQ(directions[i].has_value(), i == 6) << i;
  EXPECT_LE(offDeg(directions[6].value_or(1.5), 0.0), 20.0);
}
