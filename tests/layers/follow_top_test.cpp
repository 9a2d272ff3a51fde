// Last layers end on the part's surface where that runs nearly along them.
#include "base/run_context.h"
#include "base/units.h"
#include "curved/curved_layers.h"
#include "helpers/all_seeds.h"
#include "helpers/flat_square.h"
#include "layers/follow_top.h"
#include "layers/layer_checks.h"
#include "layers/stack_checker.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace voluta {
namespace {

using Eigen::Vector3d;

// A block with a roof that rises along x at `degrees`.
geometry::TriangleMesh ramp(double degrees) {
  geometry::TriangleMesh m = test::box({-15, -10, 0}, {15, 10, 8});
  for (Vector3d& v : m.vertices)
    if (v.z() > 1.0)
      v.z() += (v.x() + 15.0) * std::tan(base::degreesToRadians(degrees));
  return m;
}

curved::LayersResult flatLayersOf(const geometry::TriangleMesh& part, double spacing) {
  const auto d = test::decompositionOf(part, 0.8, [](const Vector3d& p) { return p.z(); });
  return curved::curvedLayers(d, part, {spacing, 0.4, 1.0, 1.2, false}, base::RunContext({}, 2));
}

TEST(FollowTop, EndsLayersOnARampThatRunsNearlyAlongThem) {
  for (const double spacing : {0.6, 0.8})
    for (const double degrees : spacing < 0.7 && !test::allSeeds()
                                    ? std::vector{4.0}
                                    : std::vector{0.7, 4.0, 12.0, 20.0}) {
      SCOPED_TRACE(testing::Message() << spacing << " mm, " << degrees << " degrees");
      const auto part = ramp(degrees);
      const auto r = flatLayersOf(part, spacing);
      const auto v = test::checkStack(r.stack, part, 0.4, 1.0);
      EXPECT_GT(v.flatTopShare, 0.15);
      EXPECT_LT(v.flatTopMeanMm, 0.07); // a quarter of a height is the value for plain levels
      EXPECT_LT(v.flatTopP99Mm, 0.2);
      EXPECT_NEAR(v.volumeRatio, 1.0, 0.01);
      EXPECT_GT(r.statistics.withinLimitsFraction, 0.9999);
      EXPECT_GT(v.within, 0.97);
      EXPECT_LT(v.inSeveral, 0.01);
      EXPECT_EQ(v.nearVertices + v.looseVertices + v.notSimple, 0u);
      EXPECT_LE(r.boundaryFarthestMm, 1e-3);
      EXPECT_EQ(v.patchesInTheAir, 0u);
    }
}

TEST(FollowTop, SharesExcessThicknessWithTheLayerBelow) {
  const auto part =
      test::box({-8, -8, 0}, {8, 8, 4.35}); // five layers of 0.8 and more than a limit
  const auto r = flatLayersOf(part, 0.8);
  ASSERT_EQ(r.stack.patches.size(), 5u);
  EXPECT_NEAR(r.volumeMm3, 16 * 16 * 4.35, 1e-3 * 16 * 16 * 4.35);
  const layers::Patch &last = r.stack.patches[4], &below = r.stack.patches[3];
  for (std::size_t v = 0; v < last.thicknessMm.size(); ++v) {
    EXPECT_NEAR(last.thicknessMm[v], 1.0, 1e-6);
    EXPECT_NEAR(last.surface.vertices[v].z() + 0.5 * last.thicknessMm[v], 4.35, 1e-4);
  }
  for (std::size_t v = 0; v < below.thicknessMm.size(); ++v) {
    EXPECT_NEAR(below.thicknessMm[v], 0.95, 2e-3);
    EXPECT_NEAR(below.surface.vertices[v].z() - 0.5 * below.thicknessMm[v], 2.4, 2e-3);
  }
}

TEST(FollowTop, LeavesSteepRoofsAndSupportAsTheyAre) {
  const auto part = ramp(45.0);
  const layers::PartBoundary boundary(part, 0.8, {});
  layers::LayerStack stack;
  for (int layer = 0; layer < 10; ++layer) {
    const layers::LevelSurface s = test::flatSquare(3, 0.5, 0.4 + 0.8 * layer);
    stack.patches.push_back(
        {s.surface, s.thicknessMm, s.direction, s.clearDirection, layer, 0, {}});
  }
  const auto isUnchanged = [&](const layers::LayerStack& other) {
    for (std::size_t p = 0; p < stack.patches.size(); ++p)
      if (other.patches[p].surface.vertices != stack.patches[p].surface.vertices ||
          other.patches[p].thicknessMm != stack.patches[p].thicknessMm)
        return false;
    return true;
  };
  layers::LayerStack steep = stack;
  layers::followTop(steep, boundary, {}, {});
  EXPECT_TRUE(isUnchanged(steep));

  const layers::PartBoundary flat(test::box({-15, -10, 0}, {15, 10, 8.2}), 0.8, {});
  layers::LayerStack plain = stack;
  layers::followTop(plain, flat, {}, {});
  EXPECT_FALSE(isUnchanged(plain));
  for (layers::Patch& patch : stack.patches)
    patch.group = layers::kSupportGroup;
  layers::LayerStack support = stack;
  layers::followTop(support, flat, {}, {});
  EXPECT_TRUE(isUnchanged(support));
}

} // namespace
} // namespace voluta
