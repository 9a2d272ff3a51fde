// Tilted layers beside another item's, checked before tool-paths cover them.
#include "pipeline/items/layer_hindrance.h"

#include "base/units.h"
#include "curved/platform_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Vector3d;
using ::testing::HasSubstr;

namespace {

// A square layer of 10 mm in the plane across `direction`.
layers::Patch square(const Vector3d& middle, const Vector3d& direction, int item, int layer) {
  layers::Patch patch;
  const Vector3d u = direction.unitOrthogonal(), v = direction.cross(u);
  for (const auto& [a, b] : {std::pair{-5, -5}, {5, -5}, {5, 5}, {-5, 5}})
    patch.surface.vertices.push_back(middle + a * u + b * v);
  patch.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  patch.thicknessMm.assign(4, 0.8);
  patch.direction.assign(4, direction);
  patch.clearDirection.assign(4, direction);
  patch.item = item;
  patch.layer = layer;
  return patch;
}

// A tower of flat layers at the origin, then a stub that grows towards it, level with its middle.
layers::LayerStack towerAndStub(double gapMm, double tiltDeg) {
  layers::LayerStack stack;
  for (int i = 0; i < 60; ++i)
    stack.patches.push_back(square({0, 0, 0.4 + 0.8 * i}, Vector3d::UnitZ(), 0, i));
  const double tilt = base::degreesToRadians(tiltDeg);
  const Vector3d towards(-std::sin(tilt), 0.0, std::cos(tilt));
  for (int i = 0; i < 5; ++i)
    stack.patches.push_back(
        square(Vector3d(15.0 + gapMm, 0, 24) + 0.8 * i * towards, towards, 1, 60 + i));
  stack.layerCount = 65;
  return stack;
}

std::optional<pipeline::LayerHindrance> hindranceOf(const layers::LayerStack& stack) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-moving", process, curved::platformDisc(200.0));
  return pipeline::layerHindrance(stack, cell, process, {});
}

TEST(LayerHindrance, ThereIsNoneAmongFlatLayers) {
  EXPECT_FALSE(hindranceOf(towerAndStub(2.0, 0.0)));
}

TEST(LayerHindrance, AStubThatGrowsIntoATowerIsFound) {
  const auto found = hindranceOf(towerAndStub(6.0, 150.0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->item, 1u);
  EXPECT_EQ(found->neighbour, 0u);
  EXPECT_GT(found->share, 0.01);
  ASSERT_TRUE(found->moveMm);
  EXPECT_FALSE(hindranceOf(towerAndStub(6.0 + *found->moveMm + 2.0, 150.0)))
      << "the distance that is named suffices";
}

TEST(LayerHindrance, FarApartThereIsNone) {
  EXPECT_FALSE(hindranceOf(towerAndStub(200.0, 80.0)));
}

TEST(LayerHindrance, NamesThePairAndTheRemedy) {
  const pipeline::LayerHindrance pair{1, 0, 0.25, 40.0};
  const auto texts = [&](const pipeline::LayerHindrance& hindrance, bool hasSequence) {
    const plan::Findings findings =
        pipeline::hindranceStage(hindrance, {"tower", "stub"}, hasSequence).findings;
    return std::pair(plan::englishReason(findings.at(0)), plan::englishRemedy(findings.at(0)));
  };
  EXPECT_EQ(texts(pair, true).first, "25 % of stub cannot be printed layer by layer: its layers "
                                     "tilt the head into tower");
  EXPECT_EQ(texts(pair, true).second, "print one after another, or move tower by 40 mm");
  EXPECT_EQ(texts(pair, false).second, "move tower by 40 mm");
  EXPECT_EQ(texts({1, 0, 0.25, {}}, true).second, "print one after another");
  EXPECT_EQ(texts({1, 0, 0.25, {}}, false).second, "print them as separate jobs");
  EXPECT_TRUE(pipeline::hindranceStage({}, {}, true).findings.empty());
}

} // namespace
