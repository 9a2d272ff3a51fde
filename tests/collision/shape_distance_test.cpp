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

// A head of frusta about its axis is as near as the nearest of them, and as low as the lowest.
TEST(Revolved, IsAsItsFrusta) {
  test::RandomShapes random(41);
  for (int n = 0; n < 60; ++n) {
    std::vector<robot::Frustum> frusta;
    double z = random.number(-5, 5);
    const double up = n % 2 == 0 ? 1.0 : -1.0;
    for (int k = 0; k < 3; ++k) {
      const double from = z;
      z += up * random.number(0.5, 6.0);
      frusta.push_back({{0, 0, from}, {0, 0, z}, random.number(0, 4), random.number(0, 4)});
    }
    const collision::Revolved head(frusta);
    const Eigen::Isometry3d pose = random.pose(3.0);
    const Vector3d axis = pose.linear().col(2);
    double lowest = 1e9;
    for (const robot::Frustum& f : frusta)
      lowest =
          std::min(lowest, -collision::support(f, pose.linear().transpose() * -Vector3d::UnitZ()));
    EXPECT_NEAR(head.lowest(axis), lowest, 1e-9);
    for (int k = 0; k < 40; ++k) {
      const Vector3d p = random.point(12.0), r = p - pose.translation();
      double nearest = 1e9;
      for (const robot::Frustum& f : frusta)
        nearest = std::min(nearest, collision::signedDistance(collision::place(f, pose), p));
      const double along = r.dot(axis);
      EXPECT_NEAR(
          head.signedDistance(std::sqrt(std::max(0.0, r.squaredNorm() - along * along)), along),
          nearest, 1e-7);
    }
  }
}

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
      // The nearest boundary point is |d| down the gradient (outside, where the distance is
      // smooth).
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
    double minimum = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 100; ++i)
      for (int j = 0; j <= 100; ++j)
        minimum = std::min(minimum, (a + i / 100.0 * (b - a) - c - j / 100.0 * (d - c)).norm());
    const double exact = collision::segmentDistance(a, b, c, d);
    EXPECT_LE(exact, minimum + 1e-9);
    EXPECT_GE(exact, minimum - 0.12);
  }
  EXPECT_DOUBLE_EQ(collision::segmentDistance({0, 0, 0}, {0, 0, 0}, {3, 4, 0}, {3, 4, 0}), 5.0);
}

TEST(ShapeDistance, CapsulesAgainstSolids) {
  test::RandomShapes random(3);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int n = 0; n < 400; ++n) {
    const robot::Capsule capsule{random.point(8), random.point(8), random.number(0.1, 1.0)};
    const robot::Shape other = random.shape(n, 4.0);
    const auto placed = collision::place(other, Isometry3d::Identity());
    double minimum = infinity;
    for (int i = 0; i <= 2000; ++i)
      minimum = std::min(minimum, collision::signedDistance(
                                      other, capsule.p0 + i / 2000.0 * (capsule.p1 - capsule.p0)));
    minimum -= capsule.radius;
    const double found = collision::capsuleDistance(capsule, placed, infinity);
    // Two capsules that cross: both results are negative; the depth is only bounded.
    if (minimum > 0.0)
      EXPECT_NEAR(found, minimum, 0.01) << n;
    else
      EXPECT_LT(found, 1e-3) << n;
    for (const double enough : {-1.0, 0.0, 2.0}) {
      const double quick = collision::capsuleDistance(capsule, placed, enough);
      EXPECT_EQ(quick > enough, found > enough) << n;
    }
  }
}

// No point of a solid is further along a direction, and one is as far: by many points of it, and
// for solids bounded by corners or rims by those.
TEST(ShapeDistance, SupportIsTheFurthestPoint) {
  test::RandomShapes random(4);
  for (int n = 0; n < 200; ++n) {
    const robot::Shape shape = random.shape(n, 5.0);
    const Vector3d d = random.point(1.0).normalized();
    double maximum = -std::numeric_limits<double>::infinity();
    const auto take = [&](const Vector3d& p) { maximum = std::max(maximum, p.dot(d)); };
    if (const auto* c = std::get_if<robot::Capsule>(&shape)) {
      for (const Vector3d& end : {c->p0, c->p1})
        take(end + c->radius * d);
    } else if (const auto* b = std::get_if<robot::Box>(&shape)) {
      for (int k = 0; k < 8; ++k)
        take(b->frame_T_box * Vector3d(k & 1 ? b->half.x() : -b->half.x(),
                                       k & 2 ? b->half.y() : -b->half.y(),
                                       k & 4 ? b->half.z() : -b->half.z()));
    } else if (const auto* f = std::get_if<robot::Frustum>(&shape)) {
      const Vector3d u = (f->p1 - f->p0).normalized(), x = u.unitOrthogonal(), y = u.cross(x);
      for (int k = 0; k < 7200; ++k) {
        const double a = k * base::kTwoPi / 7200;
        const Vector3d rim = std::cos(a) * x + std::sin(a) * y;
        take(f->p0 + f->r0 * rim);
        take(f->p1 + f->r1 * rim);
      }
    } else {
      const auto& prism = std::get<robot::Prism>(shape);
      for (const Eigen::Vector2d& corner : prism.polygon)
        for (const double z : {prism.zMin, prism.zMax})
          take({corner.x(), corner.y(), z});
    }
    EXPECT_NEAR(collision::support(shape, d), maximum, 1e-5) << n;
    // And its ball is as large as it has to be about its middle.
    const collision::Ball ball =
        collision::boundingBall(collision::place(shape, Isometry3d::Identity()));
    EXPECT_GE(ball.centre.dot(d) + ball.radius, maximum - 1e-9);
  }
}

TEST(ShapeDistance, ABallIsNoLargerThanItsShape) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = Vector3d(7, -8, 9);
  const auto ballOf = [&](const robot::Shape& shape) {
    return collision::boundingBall(collision::place(shape, pose));
  };
  const auto expectBall = [&](const collision::Ball& ball, const Vector3d& centre, double radius) {
    EXPECT_LT((ball.centre - pose * centre).norm(), 1e-9);
    EXPECT_NEAR(ball.radius, radius, 1e-9);
  };
  expectBall(ballOf(robot::Capsule{{1, 2, 3}, {1, 2, 9}, 2.0}), {1, 2, 6}, 5.0);
  const Isometry3d there(Eigen::Translation3d(4, 5, 6));
  expectBall(ballOf(robot::Box{there, {2, 3, 6}}), {4, 5, 6}, 7.0);
  expectBall(ballOf(robot::Frustum{{0, 0, 1}, {0, 0, 7}, 2.0, 4.0}), {0, 0, 4}, 5.0);
  expectBall(ballOf(robot::Prism{{{0, 0}, {6, 0}, {6, 8}, {0, 8}}, -10, 14}), {3, 4, 2}, 13.0);
}

// All places on both, where they are parallel, in one line, or without length too.
TEST(ShapeDistance, SegmentsInAnyPosition) {
  test::RandomShapes random(5);
  const auto grid = [&] {
    return Vector3d(std::round(random.number(-2, 2)), std::round(random.number(-2, 2)),
                    std::round(random.number(-2, 2)));
  };
  // Of a convex function over [0, 1], by thirds.
  const auto minimum = [](const auto& f) {
    double a = 0.0, b = 1.0;
    for (int k = 0; k < 50; ++k) {
      const double u = a + (b - a) / 3.0, v = b - (b - a) / 3.0;
      if (f(u) < f(v))
        b = v;
      else
        a = u;
    }
    return f(0.5 * (a + b));
  };
  for (int n = 0; n < 200; ++n) {
    const Vector3d a = grid(), b = grid(), c = grid(), d = grid();
    const double wanted = minimum([&](double s) {
      const Vector3d p = a + s * (b - a);
      return minimum([&](double t) { return (p - c - t * (d - c)).norm(); });
    });
    EXPECT_NEAR(collision::segmentDistance(a, b, c, d), wanted, 1e-6) << n;
    EXPECT_NEAR(collision::segmentDistance(d, c, a, b), wanted, 1e-6) << n;
  }
}
