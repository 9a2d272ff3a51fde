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
    double minimum = 1e9;
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
      minimum = std::min(minimum, value);
    }
    EXPECT_NEAR(distance, minimum, 0.02) << round;
    EXPECT_NEAR(distance, distanceBetween(b, f, a, Isometry3d::Identity()), 2e-4) << round;
  }
}

// Least of a convex function of one or two numbers in [0, 1], by thirds.
template <typename F> double minimumOfOne(const F& f) {
  double a = 0.0, b = 1.0;
  for (int k = 0; k < 50; ++k) {
    const double u = a + (b - a) / 3.0, v = b - (b - a) / 3.0;
    if (f(u) < f(v))
      b = v;
    else
      a = u;
  }
  return f(0.5 * (a + b));
}
double minimumOfSegments(const Vector3d& p0, const Vector3d& p1, const Vector3d& q0,
                         const Vector3d& q1) {
  return minimumOfOne([&](double s) {
    const Vector3d p = p0 + s * (p1 - p0);
    return minimumOfOne([&](double t) { return (p - q0 - t * (q1 - q0)).norm(); });
  });
}

// All relative positions of two segments, also parallel, in one line, and without length.
TEST(Distances, SegmentsAgainstAllPlacesOnBoth) {
  std::mt19937 random(21);
  std::uniform_int_distribution<int> grid(-2, 2);
  std::uniform_real_distribution<double> u(-3, 3);
  for (int round = 0; round < 400; ++round) {
    const auto point = [&] {
      return round % 2 ? Vector3d(grid(random), grid(random), grid(random))
                       : Vector3d(u(random), u(random), u(random));
    };
    const Vector3d p0 = point(), p1 = point(), q0 = point(), q1 = point();
    const double wanted = minimumOfSegments(p0, p1, q0, q1);
    EXPECT_NEAR(segmentDistance(p0, p1, q0, q1), wanted, 1e-6) << round;
    EXPECT_NEAR(segmentDistance(q1, q0, p0, p1), wanted, 1e-6) << round;
    const robot::Capsule a{p0, p1, 0.3}, b{q0, q1, 0.2};
    EXPECT_NEAR(distanceBetween(a, at(0, 0, 0), b, at(0, 0, 0)), std::max(0.0, wanted - 0.5), 1e-6);
  }
}

std::vector<Vector3d> cornersOf(const robot::Box& b, const Isometry3d& frame) {
  std::vector<Vector3d> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(frame * b.frame_T_box *
                      Vector3d((k & 1 ? 1 : -1) * b.half.x(), (k & 2 ? 1 : -1) * b.half.y(),
                               (k & 4 ? 1 : -1) * b.half.z()));
  return corners;
}
Vector3d anyDirection(std::mt19937& random) {
  std::normal_distribution<double> n;
  return Vector3d(n(random), n(random), n(random)).normalized();
}

// The distance of two boxes is that of an edge of one to the other. Large ones, thin ones, flat
// ones without any height, and ones of a few hundredths.
TEST(Distances, BoxesAgainstTheirEdges) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> u(0.2, 1.0);
  int apart = 0, met = 0;
  for (int round = 0; round < 120; ++round) {
    const double size = std::vector{1.0, 300.0, 0.02}[static_cast<std::size_t>(round % 3)];
    const auto box = [&](bool flat) {
      Isometry3d f = Isometry3d::Identity();
      f.rotate(Eigen::AngleAxisd(round % 4 ? 6.0 * u(random) : 0.0, anyDirection(random)));
      return robot::Box{f, size * Vector3d(u(random), u(random), flat ? 0.0 : 0.1 * u(random))};
    };
    const robot::Box a = box(false), b = box(round % 5 == 0);
    Isometry3d frame = Isometry3d::Identity();
    frame.translation() = size * (2.0 * u(random) + 0.2) * anyDirection(random);
    const std::vector<Vector3d> p = cornersOf(a, Isometry3d::Identity()), q = cornersOf(b, frame);
    // Edges join corners that differ in one digit.
    double wanted = 1e9;
    for (std::size_t i = 0; i < 8; ++i)
      for (const std::size_t d : {1u, 2u, 4u})
        if (!(i & d))
          wanted = std::min({wanted, minimumOfOne([&](double t) {
                               const Vector3d on = p[i] + t * (p[i + d] - p[i]);
                               return distanceToPoint(b, frame.inverse(Eigen::Isometry) * on);
                             }),
                             minimumOfOne([&](double t) {
                               return distanceToPoint(a, q[i] + t * (q[i + d] - q[i]));
                             })});
    (wanted > 1e-3 ? apart : met)++;
    EXPECT_NEAR(distanceBetween(a, Isometry3d::Identity(), b, frame), wanted, 2e-4) << round;
    EXPECT_NEAR(distanceBetween(b, frame, a, Isometry3d::Identity()), wanted, 2e-4) << round;
  }
  EXPECT_GT(apart, 40);
  EXPECT_GT(met, 20);
}

// A ball's distance is its centre's less its radius, for every solid; inside it is 0.
TEST(Distances, ABallIsItsCentreLessItsRadius) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> u(-20, 20), r(0.1, 3.0);
  for (int round = 0; round < 200; ++round) {
    const robot::Shape shape = randomShape(random, 1 + round % 3);
    Isometry3d frame = at(u(random), u(random), u(random));
    frame.rotate(Eigen::AngleAxisd(u(random), anyDirection(random)));
    const Vector3d centre(u(random), u(random), u(random));
    const double radius = r(random);
    const robot::Capsule ball{centre, centre, radius};
    const double wanted = std::max(0.0, distanceToPoint(shape, frame.inverse() * centre) - radius);
    EXPECT_NEAR(distanceBetween(ball, at(0, 0, 0), shape, frame), wanted, 2e-4) << round;
    EXPECT_NEAR(distanceBetween(shape, frame, ball, at(0, 0, 0)), wanted, 2e-4) << round;
    // A capsule's, anywhere along it.
    const Vector3d end(u(random), u(random), u(random));
    const double along = minimumOfOne([&](double t) {
      return distanceToPoint(shape, frame.inverse() * (centre + t * (end - centre)));
    });
    EXPECT_NEAR(distanceBetween(robot::Capsule{centre, end, radius}, at(0, 0, 0), shape, frame),
                std::max(0.0, along - radius), 2e-4)
        << round;
  }
}

// Points that fill each solid: one outside is as far as the nearest of them, to their spacing.
TEST(Distances, APointToASolidIsToItsNearestPoint) {
  std::mt19937 random(24);
  std::uniform_real_distribution<double> u(-1, 1);
  const robot::Frustum frustum{{1, 0, 0}, {1, 3, 4}, 2.0, 0.5};
  const robot::Prism prism{{{0, 0}, {4, 0}, {5, 2}, {2, 4}, {-1, 2}}, -1.0, 2.0};
  const Vector3d axis(0, 0.6, 0.8), x(1, 0, 0), y = axis.cross(x);
  std::vector<Vector3d> inFrustum, inPrism;
  for (int i = 0; i <= 50; ++i)
    for (int k = 0; k < 90; ++k)
      for (int d = 0; d <= 20; ++d) {
        const double t = i / 50.0, a = k * 0.0698131700797732, rho = d / 20.0 * (2.0 - 1.5 * t);
        inFrustum.push_back(Vector3d(1, 0, 0) + 5.0 * t * axis +
                            rho * (std::cos(a) * x + std::sin(a) * y));
      }
  for (int i = 0; i < 5; ++i) // a fan about a point inside
    for (int b = 0; b <= 40; ++b)
      for (int c = 0; b + c <= 40; ++c)
        for (int k = 0; k <= 30; ++k) {
          const Eigen::Vector2d m(2, 2), p = m + b / 40.0 * (prism.polygon[i] - m) +
                                             c / 40.0 * (prism.polygon[(i + 1) % 5] - m);
          inPrism.emplace_back(p.x(), p.y(), -1.0 + 0.1 * k);
        }
  for (int round = 0; round < 60; ++round) {
    const Vector3d p = Vector3d(1, 2, 1) + 7.0 * Vector3d(u(random), u(random), u(random));
    for (const auto& [shape, filled] :
         {std::pair<robot::Shape, const std::vector<Vector3d>&>{frustum, inFrustum},
          {prism, inPrism}}) {
      double minimum = 1e9;
      for (const Vector3d& q : filled)
        minimum = std::min(minimum, (p - q).norm());
      const double distance = distanceToPoint(shape, p);
      EXPECT_LE(distance, minimum + 1e-9);
      EXPECT_GE(distance, minimum - 0.15);
      if (minimum > 1.0) {
        EXPECT_NEAR(distance, minimum, 0.02) << round;
      }
    }
  }
}

// Holds all of the shape, and touches it where the shape is a ball, box or prism about its middle.
TEST(Distances, ABallRoundAShapeHoldsIt) {
  const Ball capsule = ballRound(robot::Capsule{{1, 2, 3}, {1, 2, 9}, 2.0});
  EXPECT_LT((capsule.centre - Vector3d(1, 2, 6)).norm(), 1e-12);
  EXPECT_NEAR(capsule.radius, 5.0, 1e-12);
  const Ball box = ballRound(robot::Box{at(4, 5, 6), {2, 3, 6}});
  EXPECT_LT((box.centre - Vector3d(4, 5, 6)).norm(), 1e-12);
  EXPECT_NEAR(box.radius, 7.0, 1e-12);
  const Ball frustum = ballRound(robot::Frustum{{0, 0, 1}, {0, 0, 7}, 2.0, 4.0});
  EXPECT_LT((frustum.centre - Vector3d(0, 0, 4)).norm(), 1e-12);
  EXPECT_NEAR(frustum.radius, 5.0, 1e-12);
  const Ball prism = ballRound(robot::Prism{{{0, 0}, {6, 0}, {6, 8}, {0, 8}}, -10, 14});
  EXPECT_LT((prism.centre - Vector3d(3, 4, 2)).norm(), 1e-12);
  EXPECT_NEAR(prism.radius, 13.0, 1e-12);
}

TEST(Distances, ALeaningHeadIsAsLowAsItsLowestRim) {
  const HeadSolid head({{{0.0, 0.5}, {10.0, 4.0}, {30.0, 4.0}, {30.0, 15.0}, {60.0, 15.0}}});
  for (const double lean : {0.0, 0.3, 0.8, 1.2, 1.5}) {
    Isometry3d frame = at(0, 0, 5);
    frame.rotate(Eigen::AngleAxisd(lean, Vector3d(1, 2, 0).normalized()));
    double low = 1e9; // of rims, by points
    for (const auto& [z, radius] :
         {std::pair(0.0, 0.5), {10.0, 4.0}, {30.0, 4.0}, {30.0, 15.0}, {60.0, 15.0}})
      for (int k = 0; k < 3600; ++k) {
        const double a = k * 0.00174532925199433;
        low = std::min(low, (frame * Vector3d(radius * std::cos(a), radius * std::sin(a), z)).z());
      }
    EXPECT_NEAR(head.lowest(5.0, std::cos(lean)), low, 1e-4) << lean;
  }
  EXPECT_NEAR(head.ball().centre.z(), 30.0, 1e-12);
  EXPECT_NEAR(head.ball().radius, std::hypot(30.0, 15.0), 1e-12);
}

// Near and far, above and below: within() agrees with distance(), at any reach.
TEST(Distances, WithinReachAgreesWithTheDistance) {
  const HeadSolid head({{{0.0, 0.5}, {10.0, 4.0}, {30.0, 4.0}, {30.0, 15.0}, {60.0, 15.0}}});
  std::mt19937 random(25);
  std::uniform_real_distribution<double> across(-25, 25), up(-12, 75);
  for (int k = 0; k < 4000; ++k) {
    const Vector3d p(across(random), across(random), up(random));
    const double distance = head.distance(p);
    for (const double reach : {0.0, 0.5, 4.0, 10.0})
      EXPECT_EQ(head.within(p.head<2>().squaredNorm(), p.z(), reach), distance <= reach) << k;
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
    double minimum = 1e9;
    for (const robot::Shape& f : head.frusta())
      minimum = std::min(minimum, distanceToPoint(f, p));
    EXPECT_NEAR(head.distance(p), minimum, 1e-9);
    EXPECT_EQ(head.within(p.head<2>().squaredNorm(), p.z(), 3.0), minimum <= 3.0);
  }
  EXPECT_NEAR(head.lowest(1.0, 1.0), 1.0, 1e-12);
  EXPECT_NEAR(head.lowest(30.0, 0.0), 8.0, 1e-12);
}

} // namespace
} // namespace voluta::replay
