// Measures at clicked points, on shapes whose sizes are known.
#include "geometry/measuring.h"

#include "base/units.h"
#include "helpers/shapes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta::geometry {
namespace {

using Eigen::Vector3d;
using On = MeasuredPoint::On;
using Of = RoundShape::Of;

constexpr double kSnapMm = 0.5;

// A pipe along z with flat ends, its walls of `sides` strips; radii of the vertices.
TriangleMesh pipe(int sides, double outerMm, double innerMm, double heightMm) {
  TriangleMesh mesh;
  for (int i = 0; i < sides; ++i)
    for (const double radius : {outerMm, innerMm})
      for (const double z : {0.0, heightMm}) {
        const double angle = base::kTwoPi * i / sides;
        mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
      }
  const auto quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < sides; ++i) {
    const int at = 4 * i, next = 4 * ((i + 1) % sides);
    quad(at, next, next + 1, at + 1);         // outside
    quad(next + 2, at + 2, at + 3, next + 3); // inside
    quad(at + 1, next + 1, next + 3, at + 3); // top
    quad(next, at, at + 2, next + 2);         // bottom
  }
  return mesh;
}

TriangleMesh ball(double radiusMm, const Vector3d& centre, int rings) {
  TriangleMesh mesh;
  const int sides = 2 * rings;
  mesh.vertices.emplace_back(centre - Vector3d(0, 0, radiusMm));
  for (int r = 1; r < rings; ++r)
    for (int i = 0; i < sides; ++i) {
      const double up = base::kPi * r / rings - 0.5 * base::kPi, about = base::kTwoPi * i / sides;
      mesh.vertices.emplace_back(centre + radiusMm * Vector3d(std::cos(up) * std::cos(about),
                                                              std::cos(up) * std::sin(about),
                                                              std::sin(up)));
    }
  mesh.vertices.emplace_back(centre + Vector3d(0, 0, radiusMm));
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int r, int i) { return 1 + (r - 1) * sides + i % sides; };
  for (int i = 0; i < sides; ++i) {
    mesh.triangles.push_back({0, at(1, i + 1), at(1, i)});
    mesh.triangles.push_back({last, at(rings - 1, i), at(rings - 1, i + 1)});
    for (int r = 1; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, i), at(r, i + 1), at(r + 1, i + 1)});
      mesh.triangles.push_back({at(r, i), at(r + 1, i + 1), at(r + 1, i)});
    }
  }
  return mesh;
}

// A long block whose upper edge along y is rounded: a quarter of a cylinder that goes on smoothly
// in two flat faces.
TriangleMesh roundedBlock(double radiusMm, int strips) {
  std::vector<Eigen::Vector2d> outline{{-20, 0}, {10, 0}, {10, 20 - radiusMm}};
  for (int i = 1; i <= strips; ++i) {
    const double angle = 0.5 * base::kPi * i / strips;
    outline.emplace_back(10 - radiusMm + radiusMm * std::cos(angle),
                         20 - radiusMm + radiusMm * std::sin(angle));
  }
  outline.emplace_back(-20, 20);
  TriangleMesh mesh;
  for (const double y : {0.0, 40.0})
    for (const Eigen::Vector2d& p : outline)
      mesh.vertices.emplace_back(p.x(), y, p.y());
  const int n = static_cast<int>(outline.size());
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    mesh.triangles.push_back({i, n + next, next});
    mesh.triangles.push_back({i, n + i, n + next});
    if (i >= 1 && i + 1 < n) { // the ends, fans about the first corner
      mesh.triangles.push_back({0, i, i + 1});
      mesh.triangles.push_back({n, n + i + 1, n + i});
    }
  }
  return mesh;
}

TEST(Measuring, ABoxHasCornersEdgesAndWalls) {
  const Measuring measuring(test::box({0, 0, 0}, {30, 20, 10}));
  const MeasuredPoint corner = measuring.at({0.2, 0.1, 10.0}, kSnapMm);
  EXPECT_EQ(corner.on, On::Corner);
  EXPECT_EQ(corner.point, Vector3d(0, 0, 10));
  EXPECT_FALSE(corner.wallMm);
  const MeasuredPoint edge = measuring.at({12.0, 0.3, 10.0}, kSnapMm);
  EXPECT_EQ(edge.on, On::Edge);
  EXPECT_LT((edge.point - Vector3d(12, 0, 10)).norm(), 1e-12);
  EXPECT_NEAR(std::abs(edge.direction.x()), 1.0, 1e-12);
  EXPECT_FALSE(edge.round);
  const MeasuredPoint top = measuring.at({12.0, 7.0, 10.3}, kSnapMm);
  EXPECT_EQ(top.on, On::Face);
  EXPECT_LT((top.point - Vector3d(12, 7, 10)).norm(), 1e-12);
  EXPECT_FALSE(top.round);
  EXPECT_NEAR(*top.wallMm, 10.0, 1e-9);
  EXPECT_NEAR(*measuring.at({30.0, 7.0, 4.0}, kSnapMm).wallMm, 30.0, 1e-9);
  EXPECT_EQ(measuring.at({12.0, 0.3, 10.0}, 0.1).on, On::Face) << "farther than it snaps";
}

TEST(Measuring, PairsHaveDistanceAnglesAndParallelPlanes) {
  const Measuring measuring(test::box({0, 0, 0}, {30, 20, 10}));
  const auto at = [&](double x, double y, double z) { return measuring.at({x, y, z}, kSnapMm); };
  const MeasuredPair corners = measuredPair(at(0, 0, 0), at(30, 20, 10));
  EXPECT_NEAR(corners.distanceMm, std::sqrt(1400.0), 1e-12);
  EXPECT_EQ(corners.alongAxesMm, Vector3d(30, 20, 10));
  EXPECT_FALSE(corners.angleRad);
  const MeasuredPair opposite = measuredPair(at(12, 7, 0), at(20, 9, 10));
  EXPECT_NEAR(*opposite.planesMm, 10.0, 1e-12);
  EXPECT_NEAR(*opposite.angleRad, 0.0, 1e-12);
  EXPECT_GT(opposite.distanceMm, 10.0);
  const MeasuredPair beside = measuredPair(at(12, 7, 10), at(30, 7, 4));
  EXPECT_NEAR(*beside.angleRad, 0.5 * base::kPi, 1e-12);
  EXPECT_FALSE(beside.planesMm);
  EXPECT_NEAR(*measuredPair(at(12, 0, 10), at(0, 7, 10)).angleRad, 0.5 * base::kPi, 1e-12);
  EXPECT_NEAR(*measuredPair(at(12, 0, 10), at(20, 20, 0)).angleRad, 0.0, 1e-12);
  EXPECT_NEAR(*measuredPair(at(12, 0, 10), at(12, 7, 10)).angleRad, 0.0, 1e-12) << "in the face";
  EXPECT_NEAR(*measuredPair(at(12, 0, 10), at(30, 7, 4)).angleRad, 0.5 * base::kPi, 1e-12);
}

TEST(Measuring, FacesOfAWedgeHaveItsAngle) {
  TriangleMesh wedge; // 30 degrees between the ground and the slope
  const double height = 20.0 * std::tan(base::kPi / 6.0);
  wedge.vertices = {{0, 0, 0}, {20, 0, 0}, {20, 0, height}, {0, 9, 0}, {20, 9, 0}, {20, 9, height}};
  wedge.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1},
                     {1, 4, 5}, {1, 5, 2}, {0, 2, 5}, {0, 5, 3}};
  const Measuring measuring(wedge);
  const MeasuredPoint ground = measuring.at({10, 4, 0}, kSnapMm),
                      slope = measuring.at({10, 4, 0.5 * height}, kSnapMm);
  EXPECT_NEAR(*measuredPair(ground, slope).angleRad, base::kPi / 6.0, 1e-9);
  EXPECT_NEAR(*ground.wallMm, 0.5 * height, 1e-9);
}

TEST(Measuring, APipeHasTwoRadiiAndItsWall) {
  for (const int sides : {16, 72}) {
    const Measuring measuring(pipe(sides, 10.0, 8.0, 30.0));
    const double half = base::kPi / sides; // the middle of a strip
    const Vector3d out(std::cos(half), std::sin(half), 0.0);
    const MeasuredPoint outside = measuring.at(10.0 * out + Vector3d(0, 0, 14), 0.1);
    ASSERT_EQ(outside.on, On::Face);
    ASSERT_TRUE(outside.round);
    EXPECT_EQ(outside.round->of, Of::Cylinder);
    EXPECT_NEAR(outside.round->radiusMm, 10.0, 1e-6);
    EXPECT_NEAR(std::abs(outside.round->axis.z()), 1.0, 1e-9);
    EXPECT_LT(outside.round->centre.head<2>().norm(), 1e-6);
    EXPECT_NEAR(*outside.wallMm, 2.0 * std::cos(half), 1e-9); // between flat strips
    const MeasuredPoint inside = measuring.at(8.0 * out + Vector3d(0, 0, 14), 0.1);
    ASSERT_TRUE(inside.round);
    EXPECT_NEAR(inside.round->radiusMm, 8.0, 1e-6);
    const MeasuredPoint rim = measuring.at(10.0 * out + Vector3d(0, 0, 30), kSnapMm);
    ASSERT_EQ(rim.on, On::Edge);
    ASSERT_TRUE(rim.round);
    EXPECT_EQ(rim.round->of, Of::Edge);
    EXPECT_NEAR(rim.round->radiusMm, 10.0, 1e-9);
    EXPECT_LT((rim.round->centre - Vector3d(0, 0, 30)).norm(), 1e-9);
    EXPECT_FALSE(measuring.at(9.0 * out + Vector3d(0, 0, 30), 0.1).round) << "the flat end";
  }
}

TEST(Measuring, ABallIsOneSphere) {
  const Measuring measuring(ball(7.5, {1, 2, 3}, 24));
  const MeasuredPoint found = measuring.at(Vector3d(1, 2, 3) + Vector3d(5, 4, 4), kSnapMm);
  ASSERT_TRUE(found.round);
  EXPECT_EQ(found.round->of, Of::Sphere);
  EXPECT_NEAR(found.round->radiusMm, 7.5, 1e-6);
  EXPECT_LT((found.round->centre - Vector3d(1, 2, 3)).norm(), 1e-6);
  EXPECT_NEAR(*found.wallMm, 15.0, 0.3);
}

// No edge divides a blend from the flat faces that it joins.
TEST(Measuring, ABlendHasItsRadiusAndTheFacesBesideItNone) {
  for (const int strips : {5, 18}) {
    const Measuring measuring(roundedBlock(4.0, strips));
    for (int strip = 0; strip < strips; ++strip) {
      const double angle = 0.5 * base::kPi * (strip + 0.5) / strips;
      const MeasuredPoint blend =
          measuring.at({6.0 + 4.0 * std::cos(angle), 17.0, 16.0 + 4.0 * std::sin(angle)}, 0.01);
      ASSERT_TRUE(blend.round) << strip << " of " << strips;
      EXPECT_NEAR(blend.round->radiusMm, 4.0, 1e-6) << strip;
    }
    EXPECT_FALSE(measuring.at({-8.0, 17.0, 20.0}, 0.01).round);
    EXPECT_FALSE(measuring.at({10.0, 17.0, 8.0}, 0.01).round);
    const MeasuredPoint arc =
        measuring.at({6.0 + 4.0 * std::sqrt(0.5), 0.0, 16.0 + 4.0 * std::sqrt(0.5)}, kSnapMm);
    ASSERT_EQ(arc.on, On::Edge);
    ASSERT_TRUE(arc.round);
    EXPECT_NEAR(arc.round->radiusMm, 4.0, 1e-6);
  }
}

TEST(Measuring, APrismOfFewSidesIsNotRound) {
  const Measuring measuring(pipe(6, 10.0, 6.0, 20.0));
  EXPECT_FALSE(measuring.at({0.0, 8.7, 9.0}, 0.1).round);
  EXPECT_FALSE(measuring.at({0.0, 8.66, 20.0}, kSnapMm).round);
}

TEST(Measuring, AnOpenSurfaceHasRimsAndNoWall) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Measuring measuring(sheet);
  EXPECT_FALSE(measuring.at({4, 5, 0}, 0.1).wallMm);
  EXPECT_EQ(measuring.at({4, 0.1, 0}, kSnapMm).on, On::Edge);
}

} // namespace
} // namespace voluta::geometry
