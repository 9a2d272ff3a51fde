// Painted surfaces of a part.
#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "regions/painting.h"

#include <gtest/gtest.h>

namespace voluta::test {
namespace {

using geometry::TriangleMesh;
using regions::Brush;
using regions::PaintableSurface;

PaintableSurface block() {
  return PaintableSurface(std::make_shared<const TriangleMesh>(box({-20, -20, 0}, {20, 20, 10})));
}

TEST(Painting, ABrushPaintsADiscOfACoarseFace) {
  const TriangleMesh disc = block().within({{3, 4, 10}, 5.0});
  const double area = base::kPi * 25.0;
  EXPECT_NEAR(geometry::area(disc), area, 0.03 * area);
  for (const Eigen::Vector3d& v : disc.vertices) {
    EXPECT_DOUBLE_EQ(v.z(), 10.0);
    EXPECT_LE((v - Eigen::Vector3d(3, 4, 10)).norm(), 5.0 + 1.25);
  }
}

TEST(Painting, ABrushDoesNotReachTheOtherSideOfAWall) {
  const PaintableSurface wall(std::make_shared<const TriangleMesh>(box({-20, 0, 0}, {20, 1, 40})));
  for (const Eigen::Vector3d& v : wall.within({{0, 0, 20}, 4.0}).vertices)
    EXPECT_DOUBLE_EQ(v.y(), 0.0);
}

TEST(Painting, PaintIsAddedOnceAndErased) {
  const PaintableSurface surface = block();
  const Brush brush{{0, 0, 10}, 4.0};
  TriangleMesh painted = surface.within(brush);
  const double once = geometry::area(painted);
  painted = regions::withPaint(painted, surface.within(brush));
  EXPECT_NEAR(geometry::area(painted), once, 1e-9);
  painted = regions::withPaint(painted, surface.within({{12, 0, 10}, 4.0}));
  EXPECT_NEAR(geometry::area(painted), 2.0 * once, 0.02 * once);
  // A smaller eraser leaves a ring.
  const TriangleMesh ring = regions::withoutPaint(painted, Brush{{0, 0, 10}, 2.0});
  EXPECT_NEAR(geometry::area(ring), 2.0 * once - base::kPi * 4.0, 0.05 * once);
  EXPECT_NEAR(geometry::area(regions::withoutPaint(ring, Brush{{0, 0, 10}, 6.0})), once,
              0.02 * once);
}

TEST(Painting, DabsOfAStrokeLeaveNoGapAndPaintNothingTwice) {
  const PaintableSurface surface = block();
  TriangleMesh painted;
  constexpr double kRadius = 3.0;
  for (double x = -8.0; x <= 8.0; x += 0.8) {
    const Brush brush{{x, 0, 10}, kRadius};
    painted = regions::withPaint(painted, surface.within(brush), brush);
  }
  const double area = 16.0 * 2.0 * kRadius + base::kPi * kRadius * kRadius;
  EXPECT_NEAR(geometry::area(painted), area, 0.03 * area);
  const geometry::MeshQuery query(painted, geometry::MeshQuery::Of::Surface);
  for (double x = -8.0; x <= 8.0; x += 0.25)
    for (double y = -2.0; y <= 2.0; y += 0.25)
      EXPECT_GE(query.closest({x, y, 10}, 1e-6).triangle, 0) << x << ' ' << y;
}

TEST(Painting, FacesContinueUpToAnAngle) {
  const PaintableSurface surface = block();
  const TriangleMesh top = surface.facesFrom({5, 5, 10}, base::degreesToRadians(30));
  EXPECT_NEAR(geometry::area(top), 1600.0, 1e-9);
  const TriangleMesh all = surface.facesFrom({5, 5, 10}, base::degreesToRadians(90));
  EXPECT_NEAR(geometry::area(all), 2.0 * 1600.0 + 4.0 * 400.0, 1e-9);
  const TriangleMesh rest = regions::withoutPaint(all, top);
  EXPECT_NEAR(geometry::area(rest), 1600.0 + 4.0 * 400.0, 1e-9);
  EXPECT_TRUE(regions::withoutPaint(top, all).empty());
}

} // namespace
} // namespace voluta::test
