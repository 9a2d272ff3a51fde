#include "collision/shape_distance.h"

#include "collision/random_shapes.h"

#include <gtest/gtest.h>
#include <limits>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

// Membership written from the definitions in robot/body.h, without distances.
bool inside(const robot::Shape& shape, const Vector3d& p) {
  if (const auto* c = std::get_if<robot::Capsule>(&shape)) {
    for (int i = 0; i <= 2000; ++i)
      if ((p - c->p0 - i / 2000.0 * (c->p1 - c->p0)).norm() <= c->radius)
        return true;
    return false;
  }
  if (const auto* b = std::get_if<robot::Box>(&shape)) {
    const Vector3d q = b->frame_T_box.inverse() * p;
    return (q.cwiseAbs().array() <= b->half.array()).all();
  }
  if (const auto* f = std::get_if<robot::Frustum>(&shape)) {
    const Vector3d u = (f->p1 - f->p0).normalized();
    const double length = (f->p1 - f->p0).norm(), z = (p - f->p0).dot(u);
    const double rho = (p - f->p0 - z * u).norm();
    return z >= 0 && z <= length && rho <= f->r0 + (f->r1 - f->r0) * z / length;
  }
  const auto& prism = std::get<robot::Prism>(shape);
  if (p.z() < prism.zMin || p.z() > prism.zMax)
    return false;
  for (std::size_t i = 0; i < prism.polygon.size(); ++i) {
    const Eigen::Vector2d a = prism.polygon[i], b = prism.polygon[(i + 1) % prism.polygon.size()];
    const Eigen::Vector2d e = b - a, r = p.head<2>() - a;
    if (e.x() * r.y() - e.y() * r.x() < 0)
      return false;
  }
  return true;
}

} // namespace

TEST(ShapeDistance, KnownValues) {
  const robot::Capsule capsule{{0, 0, 0}, {0, 0, 10}, 2};
  EXPECT_DOUBLE_EQ(collision::signedDistance(capsule, {5, 0, 5}), 3.0);
  EXPECT_DOUBLE_EQ(collision::signedDistance(capsule, {0, 0, 13}), 1.0);
  EXPECT_DOUBLE_EQ(collision::signedDistance(capsule, {0, 0, 5}), -2.0);
  const robot::Box box{Isometry3d::Identity(), {1, 2, 3}};
  EXPECT_DOUBLE_EQ(collision::signedDistance(box, {4, 6, 0}), 5.0);
  EXPECT_DOUBLE_EQ(collision::signedDistance(box, {0, 0, 0}), -1.0);
  const robot::Frustum cone{{0, 0, 0}, {0, 0, 4}, 3, 0}; // side from (3,0) to (0,4): a 3-4-5
  EXPECT_NEAR(collision::signedDistance(cone, {0, 0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(collision::signedDistance(cone, {3, 0, 4}), 2.4, 1e-12);
  EXPECT_NEAR(collision::signedDistance(cone, {0, 0, 1}), -1.0, 1e-12);
  EXPECT_NEAR(collision::signedDistance(cone, {0, 0, 6}), 2.0, 1e-12);
  const robot::Prism prism{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, -1, 0};
  EXPECT_DOUBLE_EQ(collision::signedDistance(prism, {5, 1, 4}), 5.0);
  EXPECT_DOUBLE_EQ(collision::signedDistance(prism, {1, 1, -0.25}), -0.25);
}

// The sign is that of membership, and the ball of that radius holds no point of the other side;
// a boundary point is found at that distance (by walking down the numeric gradient).
TEST(ShapeDistance, AgreesWithMembership) {
  test::RandomShapes random(1);
  for (int n = 0; n < 400; ++n) {
    const robot::Shape shape = random.shape(n, 5.0);
    const Isometry3d pose = random.pose(5.0);
    const collision::PlacedShape placed = collision::place(shape, pose);
    for (int m = 0; m < 10; ++m) {
      const Vector3d p = random.point(9.0);
      const double d = collision::signedDistance(placed, pose * p);
      EXPECT_NEAR(d, collision::signedDistance(shape, p), 1e-9);
      if (std::abs(d) < 1e-3)
        continue;
      EXPECT_EQ(d < 0, inside(shape, p)) << n;
      for (int k = 0; k < 20; ++k) {
        const Vector3d near = p + 0.98 * std::abs(d) * random.point(1.0).normalized();
        EXPECT_EQ(d < 0, inside(shape, near)) << n;
      }
      // The nearest boundary point lies |d| down the gradient (outside, where it is smooth).
      if (d > 0.0) {
        Vector3d g;
        for (int a = 0; a < 3; ++a) {
          const Vector3d h = 1e-6 * Vector3d::Unit(a);
          g(a) = collision::signedDistance(shape, p + h) - collision::signedDistance(shape, p - h);
        }
        const Vector3d beyond = p - (d + 2e-3) * g.normalized();
        EXPECT_LT(collision::signedDistance(shape, beyond), 1e-2) << n;
      }
    }
    const collision::Ball ball = collision::boundingBall(placed);
    for (int m = 0; m < 200; ++m) {
      const Vector3d p = random.point(9.0);
      if (inside(shape, p)) {
        EXPECT_LE((pose * p - ball.centre).norm(), ball.radius + 1e-9);
      }
    }
  }
}

TEST(ShapeDistance, SegmentsAgainstSampling) {
  test::RandomShapes random(2);
  for (int n = 0; n < 300; ++n) {
    const Vector3d a = random.point(3), b = random.point(3), c = random.point(3);
    const Vector3d d = n % 5 == 0 ? Vector3d(c + 0.7 * (b - a)) : random.point(3);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 100; ++i)
      for (int j = 0; j <= 100; ++j)
        least = std::min(least, (a + i / 100.0 * (b - a) - c - j / 100.0 * (d - c)).norm());
    const double exact = collision::segmentDistance(a, b, c, d);
    EXPECT_LE(exact, least + 1e-9);
    EXPECT_GE(exact, least - 0.12);
  }
  EXPECT_DOUBLE_EQ(collision::segmentDistance({0, 0, 0}, {0, 0, 0}, {3, 4, 0}, {3, 4, 0}), 5.0);
}

TEST(ShapeDistance, CapsulesAgainstSolids) {
  test::RandomShapes random(3);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int n = 0; n < 400; ++n) {
    const robot::Capsule capsule{random.point(8), random.point(8), random.number(0.1, 1.0)};
    const robot::Shape other = random.shape(n, 4.0);
    const auto placedCapsule =
        std::get<collision::PlacedCapsule>(collision::place(capsule, Isometry3d::Identity()));
    const auto placed = collision::place(other, Isometry3d::Identity());
    double least = infinity;
    for (int i = 0; i <= 2000; ++i)
      least = std::min(least, collision::signedDistance(
                                  other, capsule.p0 + i / 2000.0 * (capsule.p1 - capsule.p0)));
    least -= capsule.radius;
    const double found = collision::capsuleDistance(placedCapsule, placed, infinity);
    // Two capsules that cross: both say so; how deep is only bounded.
    if (least > 0.0)
      EXPECT_NEAR(found, least, 0.01) << n;
    else
      EXPECT_LT(found, 1e-3) << n;
    for (const double enough : {-1.0, 0.0, 2.0}) {
      const double quick = collision::capsuleDistance(placedCapsule, placed, enough);
      EXPECT_EQ(quick > enough, found > enough) << n;
    }
  }
}
