// Painted surfaces of a part.
#include "base/units.h"
#include "geometry/append_mesh.h"
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
    painted = regions::withPaint(painted, surface.within(brush), regions::finestOf(brush));
  }
  const double area = 16.0 * 2.0 * kRadius + base::kPi * kRadius * kRadius;
  EXPECT_NEAR(geometry::area(painted), area, 0.03 * area);
  const geometry::MeshQuery query(painted, geometry::MeshQuery::Of::Surface);
  for (double x = -8.0; x <= 8.0; x += 0.25)
    for (double y = -2.0; y <= 2.0; y += 0.25)
      EXPECT_GE(query.closest({x, y, 10}, 1e-6).triangle, 0) << x << ' ' << y;
}

// A plate with a smaller block on it, from above: 10 mm of the plate beside the block are seen.
TEST(Painting, ARectanglePaintsWhatIsSeenThroughIt) {
  TriangleMesh part = box({-30, -30, 0}, {30, 30, 5});
  const TriangleMesh roof = box({0, -30, 10}, {30, 30, 12});
  geometry::appendMesh(part, roof);
  const PaintableSurface surface(std::make_shared<const TriangleMesh>(part));
  const Eigen::Vector3d eye(0, 0, 1000);
  const auto through = [&](double x0, double y0, double x1, double y1, double z) {
    regions::SeenThrough seen;
    seen.eye = eye;
    seen.corners = {Eigen::Vector3d(x0, y0, z) - eye, Eigen::Vector3d(x1, y0, z) - eye,
                    Eigen::Vector3d(x1, y1, z) - eye, Eigen::Vector3d(x0, y1, z) - eye};
    return seen;
  };
  const TriangleMesh left = surface.seen(through(-25, -10, -5, 10, 5), 0.5);
  EXPECT_NEAR(geometry::area(left), 20.0 * 20.0, 1e-6) << "clipped at the rectangle";
  for (const Eigen::Vector3d& v : left.vertices)
    EXPECT_NEAR(v.z(), 5.0, 1e-9);
  const TriangleMesh both = surface.seen(through(-10, -10, 10, 10, 12), 0.5);
  double onRoof = 0.0, onPlate = 0.0;
  for (std::size_t t = 0; t < both.triangles.size(); ++t) {
    const double area =
        0.5 *
        (both.corner(t, 1) - both.corner(t, 0)).cross(both.corner(t, 2) - both.corner(t, 0)).norm();
    (both.corner(t, 0).z() > 8.0 ? onRoof : onPlate) += area;
  }
  EXPECT_NEAR(onRoof, 10.0 * 20.0, 1e-6);
  EXPECT_NEAR(onPlate, 10.0 * 20.0, 8.0) << "the roof hides the rest";
  // Erased again, and the rest stays.
  const TriangleMesh top = surface.facesFrom({-20, 0, 5}, 0.1);
  const TriangleMesh rest = regions::withoutPaint(top, left, 0.5);
  EXPECT_NEAR(geometry::area(rest), geometry::area(top) - 400.0, 20.0);
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
