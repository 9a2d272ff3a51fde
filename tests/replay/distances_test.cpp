#include "replay/distances.h"

#include "process/process.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d at(double x, double y, double z) {
  return Isometry3d(Eigen::Translation3d(x, y, z));
}

TEST(Distances, CapsulesInClosedForm) {
  const robot::Capsule a{{0, 0, 0}, {0, 0, 100}, 10}, b{{0, 0, 0}, {100, 0, 0}, 5};
  EXPECT_NEAR(distanceBetween(a, at(0, 0, 0), b, at(0, 30, 50)), 15.0, 1e-12);
  EXPECT_NEAR(distanceBetween(a, at(0, 0, 0), b, at(20, 0, 50)), 5.0, 1e-12);
  EXPECT_EQ(distanceBetween(a, at(0, 0, 0), b, at(12, 0, 50)), 0.0);
  const robot::Capsule ball{{0, 0, 0}, {0, 0, 0}, 5};
  EXPECT_NEAR(distanceBetween(a, at(0, 0, 0), ball, at(30, 40, 100)), 35.0, 1e-12);
  EXPECT_NEAR(segmentDistance({0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 0}), 2.0, 1e-12);
  // A point beside the middle of a segment, either way round.
  EXPECT_NEAR(segmentDistance({0, 0, 0}, {8, 0, 0}, {6, 2, 0}, {6, 2, 0}), 2.0, 1e-12);
  EXPECT_NEAR(segmentDistance({6, 2, 0}, {6, 2, 0}, {0, 0, 0}, {8, 0, 0}), 2.0, 1e-12);
}

TEST(Distances, BoxesFrustaAndPrisms) {
  const robot::Box box{Isometry3d::Identity(), {1, 2, 3}};
  EXPECT_NEAR(distanceBetween(box, at(0, 0, 0), box, at(5, 0, 0)), 3.0, 1e-4);
  EXPECT_NEAR(distanceBetween(box, at(0, 0, 0), box, at(5, 8, 0)), 5.0, 1e-4);
  EXPECT_EQ(distanceBetween(box, at(0, 0, 0), box, at(1.9, 0, 0)), 0.0);
  const robot::Frustum cone{{0, 0, 0}, {0, 0, 10}, 1, 4};
  const robot::Prism slab{{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, -5, 0};
  EXPECT_NEAR(distanceBetween(cone, at(3, 4, 7), slab, at(0, 0, 0)), 7.0, 1e-4);
  EXPECT_EQ(distanceBetween(cone, at(3, 4, -0.5), slab, at(0, 0, 0)), 0.0);
  // Lying on its side: its rim of 4 is the lowest.
  Isometry3d lying = at(0, 0, 10);
  lying.rotate(Eigen::AngleAxisd(1.5707963267948966, Vector3d::UnitY()));
  EXPECT_NEAR(distanceBetween(cone, lying, slab, at(0, 0, 0)), 6.0, 1e-4);
}

TEST(Distances, APointToEachSolid) {
  EXPECT_NEAR(distanceToPoint(robot::Capsule{{0, 0, 0}, {0, 0, 10}, 2}, {5, 0, 5}), 3.0, 1e-12);
  EXPECT_NEAR(distanceToPoint(robot::Box{at(1, 0, 0), {1, 1, 1}}, {5, 5, 0}), 5.0, 1e-12);
  const robot::Frustum f{{0, 0, 0}, {0, 0, 10}, 2, 2};
  EXPECT_NEAR(distanceToPoint(f, {5, 0, 14}), 5.0, 1e-12);
  EXPECT_EQ(distanceToPoint(f, {1, 1, 9}), 0.0);
  const robot::Prism p{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 0, 1};
  EXPECT_NEAR(distanceToPoint(p, {5, 6, 1}), 5.0, 1e-12);
  EXPECT_NEAR(distanceToPoint(p, {1, 1, 3}), 2.0, 1e-12);
}

robot::Shape randomShape(std::mt19937& random, int kind) {
  std::uniform_real_distribution<double> u(0.5, 8);
  switch (kind) {
  case 0:
    return robot::Capsule{{0, 0, -u(random)}, {u(random), 0, u(random)}, u(random) / 3};
  case 1: {
    Isometry3d f = at(u(random), 0, 0);
    f.rotate(Eigen::AngleAxisd(u(random), Vector3d(1, 2, 3).normalized()));
    return robot::Box{f, {u(random), u(random), u(random)}};
  }
  case 2:
    return robot::Frustum{{0, 0, 0}, {u(random), u(random), u(random)}, u(random), u(random)};
  default: {
    std::vector<Eigen::Vector2d> hexagon;
    for (int k = 0; k < 6; ++k)
      hexagon.emplace_back(u(random) > 0 ? 4 * std::cos(k * 1.0472) : 0, 3 * std::sin(k * 1.0472));
    return robot::Prism{hexagon, -u(random), u(random)};
  }
  }
}

// The distance of two solids is the least of one's distances to the other's points; points found
// by alternating projections need no support function. Here: the ball of the other around samples.
TEST(Distances, RandomPairsAgreeWithSampledPoints) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int round = 0; round < 300; ++round) {
    const robot::Shape a = randomShape(random, round % 4), b = randomShape(random, round / 4 % 4);
    Isometry3d f = at(16 * u(random), 16 * u(random), 16 * u(random));
    f.rotate(Eigen::AngleAxisd(3 * u(random), Vector3d(u(random), u(random), 1).normalized()));
    const double distance = distanceBetween(a, Isometry3d::Identity(), b, f);
    const Isometry3d inverse = f.inverse();
    // g(p) = distance to a + distance to b; its least value is the distance. Convex: descend by
    // a shrinking pattern from several starts.
    const auto g = [&](const Vector3d& p) {
      return distanceToPoint(a, p) + distanceToPoint(b, inverse * p);
    };
    double least = 1e9;
    for (int start = 0; start < 4; ++start) {
      Vector3d p = f.translation() * (start / 3.0);
      double value = g(p);
      for (double step = 8.0; step > 1e-4; step *= 0.6)
        for (int k = 0; k < 120; ++k) {
          const Vector3d q = p + step * Vector3d(u(random), u(random), u(random));
          const double v = g(q);
          if (v < value) {
            value = v;
            p = q;
          }
        }
      least = std::min(least, value);
    }
    EXPECT_NEAR(distance, least, 0.02) << round;
    EXPECT_NEAR(distance, distanceBetween(b, f, a, Isometry3d::Identity()), 2e-4) << round;
  }
}

TEST(Distances, AHeadIsItsFrusta) {
  const process::HeadShape shape{
      {{0.0, 0.9}, {12.0, 6.0}, {12.0, 10.0}, {45.0, 10.0}, {45.0, 22.0}, {110.0, 22.0}}};
  const HeadSolid head(shape);
  EXPECT_EQ(head.frusta().size(), 3u);
  EXPECT_EQ(head.distance({0, 0, 50}), 0.0);
  EXPECT_NEAR(head.distance({0, 0, -2}), 2.0, 1e-12);
  EXPECT_NEAR(head.distance({25, 0, 60}), 3.0, 1e-12);
  EXPECT_NEAR(head.distance({15, 0, 30}), 5.0, 1e-12);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-40, 40);
  for (int k = 0; k < 2000; ++k) {
    const Vector3d p(u(random), u(random), u(random) + 40);
    double least = 1e9;
    for (const robot::Shape& f : head.frusta())
      least = std::min(least, distanceToPoint(f, p));
    EXPECT_NEAR(head.distance(p), least, 1e-9);
    EXPECT_EQ(head.within(p, 3.0), least <= 3.0);
  }
  EXPECT_NEAR(head.lowest(1.0, 1.0), 1.0, 1e-12);
  EXPECT_NEAR(head.lowest(30.0, 0.0), 8.0, 1e-12);
}

} // namespace
} // namespace voluta::replay
