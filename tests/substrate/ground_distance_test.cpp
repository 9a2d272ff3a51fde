// Distances from rods in closed form against those of their meshes.
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "helpers/shapes.h"
#include "substrate/ground_distance.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta {
namespace {

using Eigen::Vector3d;
using platform::RodShape;

void expectLikeItsMesh(const RodShape& rod, double tolerance) {
  const substrate::GroundDistance closed = substrate::distanceFrom(rod);
  const geometry::MeshQuery mesh(platform::meshOf(rod, 1e-4));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> along(-40, 40), across(-8, 8);
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d p(along(random), across(random), across(random));
    const double d = mesh.signedDistance(p);
    if (std::abs(d) < 10 * tolerance)
      continue;
    EXPECT_EQ(closed.isInside(p), d < 0.0) << p.transpose();
    inside += d < 0.0;
    if (d < 0.0)
      continue;
    EXPECT_NEAR(closed.signedMm(p), d, tolerance) << p.transpose();
    EXPECT_LE(std::abs(mesh.signedDistance(closed.nearest(p))), tolerance) << p.transpose();
    EXPECT_GT(closed.outward(p).dot((p - mesh.closest(p).point).normalized()), 0.99);
  }
  EXPECT_GT(inside, 50);
}

TEST(GroundDistance, RoundRod) {
  expectLikeItsMesh(platform::straightRod(5, 60), 1e-3);
}
TEST(GroundDistance, SteppedAndTaperedRod) {
  expectLikeItsMesh({{{-30, 2}, {-10, 2}, {-10, 4}, {5, 3}, {5, 5}, {30, 2}}, 0}, 1e-3);
}
TEST(GroundDistance, Thread) {
  RodShape rod;
  for (int i = 0; i < 40; ++i)
    rod.profile.emplace_back(-20 + i, i % 2 == 0 ? 2.0 : 3.0);
  expectLikeItsMesh(rod, 1e-3);
}
TEST(GroundDistance, Prisms) {
  for (const int sides : {3, 4, 6, 7})
    expectLikeItsMesh(platform::straightRod(6, 60, sides), 1e-9);
}
TEST(GroundDistance, SteppedPrism) {
  expectLikeItsMesh({{{-30, 2}, {0, 2}, {0, 4}, {30, 4}}, 6}, 1e-9);
}
TEST(GroundDistance, TaperedPrismEqualsItsMesh) {
  expectLikeItsMesh({{{-30, 2}, {30, 4}}, 5}, 1e-9);
}

TEST(GroundDistance, Body) {
  const substrate::GroundDistance box = substrate::distanceFrom(test::box({-3, -2, -1}, {3, 2, 1}));
  EXPECT_TRUE(box.isInside({0, 0, 0.9}));
  EXPECT_FALSE(box.isInside({0, 0, 1.1}));
  EXPECT_FALSE(box.isInside({4, 0, 0}));
  EXPECT_NEAR(box.signedMm({0, 0, 3}), 2.0, 1e-12);
  EXPECT_NEAR(box.signedMm({6, 6, 0}), 5.0, 1e-12);
  EXPECT_NEAR((box.outward({0, 0, 3}) - Vector3d::UnitZ()).norm(), 0.0, 1e-12);
  const substrate::GroundDistance both =
      substrate::nearestOf({box, substrate::distanceFrom(test::box({10, -2, -1}, {12, 2, 1}))});
  EXPECT_NEAR(both.signedMm({9, 0, 0}), 1.0, 1e-12);
  EXPECT_TRUE(both.isInside({11, 0, 0}));
}

} // namespace
} // namespace voluta
