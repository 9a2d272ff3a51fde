// Pockets for stitches: closed forms of Castelli 6.3, and where a part has room for them.
#include "planar/slicing/slicing.h"
#include "planar/slicing/stitches.h"

#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "helpers/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;

Piece pieceOf(const geometry::TriangleMesh& mesh) {
  return wholePart(mesh, {});
}

std::vector<double> uniform(double height, int layers) {
  std::vector<double> bounds;
  for (int k = 0; k <= layers; ++k)
    bounds.push_back(height * k);
  return bounds;
}

// The test body of 6.3.1: chamber 8 x 2, opening 4 x 2, 6 in all, 184.3 mm3, 26 mm of filament.
TEST(Stitches, ThePocketIsCastellis) {
  const layers::Pocket pocket = pocketAt({0, 0, 20}, 8.0);
  EXPECT_NEAR(pocket.volumeMm3, 184.3, 0.05);
  EXPECT_NEAR(4.0 * pocket.volumeMm3 / (base::kPi * 9.0), 26.0, 0.1);
  EXPECT_DOUBLE_EQ(pocket.depthMm, 6.0);
  EXPECT_DOUBLE_EQ(pocket.openingMm, 4.0);
  EXPECT_DOUBLE_EQ(pocketRadius(pocket, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(pocketRadius(pocket, 3.0), 3.0);
  EXPECT_DOUBLE_EQ(pocketRadius(pocket, 5.0), 2.0);
}

// The simpler chamber of 6.3.2: a truncated cone of 49.5 mm3.
TEST(Stitches, TheConeIsCastellis) {
  const layers::Pocket cone = pocketAt({0, 0, 20}, 6.0, PocketShape::Cone);
  EXPECT_NEAR(cone.volumeMm3, 49.5, 0.05);
  EXPECT_DOUBLE_EQ(cone.depthMm, 3.0);
  EXPECT_DOUBLE_EQ(cone.openingMm, 3.0);
  EXPECT_DOUBLE_EQ(pocketRadius(cone, 0.0, PocketShape::Cone), 3.0);
  EXPECT_DOUBLE_EQ(pocketRadius(cone, 1.5, PocketShape::Cone), 2.25);
  const geometry::TriangleMesh surface = pocketSurfaces({cone}, PocketShape::Cone);
  EXPECT_NEAR(geometry::volume(surface), -cone.volumeMm3, 1e-3 * cone.volumeMm3);
}

TEST(Stitches, SurfacesFaceInwardsAndEncloseThePocket) {
  const layers::Pocket pocket = pocketAt({3, -2, 20}, 8.0);
  const geometry::TriangleMesh surface = pocketSurfaces({pocket});
  EXPECT_NEAR(geometry::volume(surface), -pocket.volumeMm3, 1e-3 * pocket.volumeMm3);
  EXPECT_NEAR(geometry::bounds(surface).max().z(), 20.0, 1e-12);
  EXPECT_NEAR(geometry::bounds(surface).min().z(), 14.0, 1e-12);
}

TEST(Stitches, ASlabHasThemOnAGrid) {
  const Piece slab = pieceOf(test::box({-30, -30, 0}, {30, 30, 12}));
  const StitchRule rule{20.0, 8.0, PocketShape::Dovetail, 8, 2.0};
  const std::vector<layers::Pocket> pockets = placePockets(slab, uniform(1.0, 12), rule);
  ASSERT_EQ(pockets.size(), 9u);
  for (const layers::Pocket& pocket : pockets) {
    EXPECT_DOUBLE_EQ(pocket.top.z(), 8.0);
    EXPECT_EQ(pocket.layer, 7);
    EXPECT_NEAR(std::remainder(pocket.top.x(), 20.0), 0.0, 1e-9);
  }
  EXPECT_TRUE(placePockets(slab, uniform(1.0, 12), {}).empty()) << "off by default";
}

// For each rule, the part surrounds each pocket by the margin, and they keep apart.
TEST(Stitches, RandomRulesKeepTheirMargins) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::size_t made = 0;
  for (int k = 0; k < 200; ++k) {
    const Vector3d half(8 + 20 * share(random), 8 + 20 * share(random), 0.0);
    const double height = 10.0 + 20.0 * share(random);
    const Piece part = pieceOf(test::box(-half, half + Vector3d(0, 0, height)));
    const StitchRule rule{6.0 + 20.0 * share(random), 3.0 + 7.0 * share(random),
                          PocketShape::Dovetail, 2 + static_cast<int>(8 * share(random)),
                          0.5 + 2.0 * share(random)};
    const int layers = 10 + static_cast<int>(20 * share(random));
    const auto pockets = placePockets(part, uniform(height / layers, layers), rule);
    made += pockets.size();
    for (std::size_t i = 0; i < pockets.size(); ++i) {
      const layers::Pocket& p = pockets[i];
      const double radius = 0.5 * rule.diameterMm + rule.marginMm;
      EXPECT_LT(std::abs(p.top.x()) + radius * std::cos(base::kPi / 24), half.x() + 1e-9);
      EXPECT_LT(std::abs(p.top.y()) + radius * std::cos(base::kPi / 24), half.y() + 1e-9);
      EXPECT_GT(p.top.z() - p.depthMm, 0.0);
      EXPECT_LT(p.top.z(), height);
      for (std::size_t j = 0; j < i; ++j) {
        const Vector3d step = p.top - pockets[j].top;
        EXPECT_TRUE(step.z() >= p.depthMm + rule.marginMm ||
                    step.head<2>().norm() >= rule.diameterMm + rule.marginMm);
      }
    }
  }
  EXPECT_GT(made, 200u);
}

// The layers lack the volume of the pockets, and no layer has other bounds for them.
TEST(Stitches, LayersKeepOutOfThem) {
  const Piece slab = pieceOf(test::box({-20, -20, 0}, {20, 20, 12}));
  SliceOptions options;
  options.heights = {0.5, 0.3, 0.8};
  const SliceResult plain = slicePieces({slab}, options, {});
  options.stitches = {24.0, 8.0, PocketShape::Dovetail, 16, 2.0};
  const SliceResult stitched = slicePieces({slab}, options, {});
  ASSERT_EQ(stitched.stack.pockets.size(), 1u);
  const layers::Pocket& pocket = stitched.stack.pockets.front();
  EXPECT_EQ(stitched.stack.layerCount, plain.stack.layerCount);
  EXPECT_NEAR(plain.volumeOfPiece[0] - stitched.volumeOfPiece[0], pocket.volumeMm3,
              0.01 * pocket.volumeMm3);
  EXPECT_EQ(pocket.layer, 15);
  EXPECT_EQ(stitched.findings.size(), plain.findings.size());
}

} // namespace
} // namespace voluta::planar
