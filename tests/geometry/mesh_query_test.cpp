#include "geometry/mesh_query.h"

#include "base/error.h"
#include "base/units.h"
#include "helpers/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector3d;
using geometry::MeshQuery;
using geometry::TriangleMesh;

using test::append;

namespace {

TriangleMesh hollowSphere() {
  TriangleMesh m = test::sphere({1, 2, 3}, 10.0, 20);
  append(m, test::sphere({1, 2, 3}, 6.0, 14), true);
  return m;
}

TriangleMesh soup(std::mt19937& random, int triangles) {
  std::uniform_real_distribution<double> at(-10.0, 10.0), near(-2.0, 2.0);
  TriangleMesh m;
  for (int t = 0; t < triangles; ++t) {
    const Vector3d centre(at(random), at(random), at(random));
    for (int k = 0; k < 3; ++k)
      m.vertices.push_back(centre + Vector3d(near(random), near(random), near(random)));
    m.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return m;
}

// Sums the solid angles by the spherical excess of the corner angles: none of the formulas the
// query uses.
double windingByExcess(const TriangleMesh& m, const Vector3d& p) {
  double sum = 0.0;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    const Vector3d a = (m.corner(t, 0) - p).normalized(), b = (m.corner(t, 1) - p).normalized(),
                   c = (m.corner(t, 2) - p).normalized();
    const auto corner = [](const Vector3d& x, const Vector3d& y, const Vector3d& z) {
      const Vector3d u = x.cross(y).normalized(), v = x.cross(z).normalized();
      return std::atan2(u.cross(v).norm(), u.dot(v));
    };
    const double excess = corner(a, b, c) + corner(b, c, a) + corner(c, a, b) - base::kPi;
    sum += a.dot(b.cross(c)) >= 0 ? excess : -excess;
  }
  return sum / (4.0 * base::kPi);
}

// Nearest point by walking down a fine barycentric lattice and bisecting round the best.
double distanceBySampling(const TriangleMesh& m, const Vector3d& p) {
  double best = 1e300;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    double u0 = 0.0, v0 = 0.0, width = 1.0, minimum = 1e300;
    for (int level = 0; level < 30; ++level) {
      double bestU = u0, bestV = v0;
      for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j) {
          const double u = std::clamp(u0 + i * width / 4, 0.0, 1.0);
          const double v = std::clamp(v0 + j * width / 4, 0.0, 1.0 - u);
          const Vector3d q = m.corner(t, 0) + u * (m.corner(t, 1) - m.corner(t, 0)) +
                             v * (m.corner(t, 2) - m.corner(t, 0));
          if ((q - p).norm() < minimum) {
            minimum = (q - p).norm();
            bestU = u;
            bestV = v;
          }
        }
      u0 = bestU;
      v0 = bestV;
      width *= 0.6;
    }
    best = std::min(best, minimum);
  }
  return best;
}

} // namespace

TEST(MeshQuery, ClosestOnBoxIsTheClampedPoint) {
  const Vector3d low(-1, -2, -3), high(4, 5, 6);
  const MeshQuery query(test::box(low, high));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(-12.0, 12.0);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p(at(random), at(random), at(random));
    const bool outside = ((p - low).minCoeff() < 0) || ((high - p).minCoeff() < 0);
    const double expected = outside ? (p - p.cwiseMax(low).cwiseMin(high)).norm()
                                    : -std::min((p - low).minCoeff(), (high - p).minCoeff());
    EXPECT_NEAR(query.signedDistance(p), expected, 1e-12);
    EXPECT_EQ(query.inside(p), !outside);
    const auto c = query.closest(p);
    EXPECT_NEAR((c.point - p).norm(), c.distance, 1e-12);
  }
}

TEST(MeshQuery, ClosestOnSoupMatchesSampling) {
  std::mt19937 random(2);
  const TriangleMesh m = soup(random, 60);
  const MeshQuery query(m);
  std::uniform_real_distribution<double> at(-15.0, 15.0);
  for (int i = 0; i < 40; ++i) {
    const Vector3d p(at(random), at(random), at(random));
    EXPECT_NEAR(query.closest(p).distance, distanceBySampling(m, p), 1e-5);
  }
}

TEST(MeshQuery, SurfaceAnswersEqualThoseOfSolidsExceptInside) {
  std::mt19937 random(9);
  const TriangleMesh m = soup(random, 200);
  const MeshQuery solid(m), surface(m, MeshQuery::Of::Surface);
  std::uniform_real_distribution<double> at(-15.0, 15.0);
  std::vector<MeshQuery::Hit> hits, same;
  for (int i = 0; i < 200; ++i) {
    const Vector3d p(at(random), at(random), at(random)), q(at(random), at(random), at(random));
    EXPECT_EQ(surface.closest(p).triangle, solid.closest(p).triangle);
    solid.hits(p, q, hits);
    surface.hits(p, q, same);
    ASSERT_EQ(same.size(), hits.size());
    EXPECT_THROW(surface.inside(p), base::Error);
  }
  EXPECT_FALSE(MeshQuery(TriangleMesh(), MeshQuery::Of::Surface).inside({0, 0, 0}));
}

TEST(MeshQuery, ClosestKeepsToItsRange) {
  const MeshQuery query(test::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(query.closest({0.5, 0.5, 3.0}, 1.9).triangle, -1);
  EXPECT_EQ(query.closest({0.5, 0.5, 3.0}, 1.9).distance, std::numeric_limits<double>::infinity());
  EXPECT_GE(query.closest({0.5, 0.5, 3.0}, 2.0).triangle, 0);
}

TEST(MeshQuery, ClosestOnDegenerateTriangles) {
  TriangleMesh m;
  m.vertices = {{0, 0, 0}, {4, 0, 0}, {2, 0, 0}, {9, 9, 9}};
  m.triangles = {{0, 1, 2}, {3, 3, 3}, {0, 0, 1}};
  const MeshQuery query(m);
  EXPECT_NEAR(query.closest({1, 3, 0}).distance, 3.0, 1e-12);
  EXPECT_NEAR(query.closest({9, 9, 10}).distance, 1.0, 1e-12);
}

TEST(MeshQuery, EmptyMesh) {
  const MeshQuery query(TriangleMesh{});
  EXPECT_EQ(query.closest({0, 0, 0}).triangle, -1);
  EXPECT_FALSE(query.inside({0, 0, 0}));
  EXPECT_FALSE(query.firstHit({0, 0, 0}, {1, 0, 0}));
}

TEST(MeshQuery, BadMeshIsAPreconditionFailure) {
  TriangleMesh m = test::box({0, 0, 0}, {1, 1, 1});
  m.triangles[0][1] = 8;
  EXPECT_THROW(MeshQuery{m}, base::Error);
  m = test::box({0, 0, 0}, {1, 1, 1});
  m.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(MeshQuery{m}, base::Error);
}

TEST(MeshQuery, WindingMatchesSphericalExcess) {
  TriangleMesh open = test::sphere({0, 0, 0}, 10.0, 24);
  open.triangles.resize(open.triangles.size() * 3 / 4);
  const MeshQuery query(open);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-14.0, 14.0);
  double worst = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Vector3d p(at(random), at(random), at(random));
    worst = std::max(worst, std::abs(query.windingNumber(p) - windingByExcess(open, p)));
  }
  EXPECT_LT(worst, 1e-2);
}

TEST(MeshQuery, HollowPartHasAnEmptyCavity) {
  const MeshQuery query(hollowSphere());
  const Vector3d centre(1, 2, 3);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> radius(0.0, 14.0);
  for (int i = 0; i < 3000; ++i) {
    const double r = radius(random);
    if (std::abs(r - 6.0) < 0.2 || std::abs(r - 10.0) < 0.2)
      continue; // between facets and sphere
    const Vector3d p =
        centre + r * Vector3d(normal(random), normal(random), normal(random)).normalized();
    EXPECT_EQ(query.inside(p), r > 6.0 && r < 10.0) << r;
    EXPECT_NEAR(query.windingNumber(p), r > 6.0 && r < 10.0 ? 1.0 : 0.0, 1e-2);
  }
}

TEST(MeshQuery, LinesThroughEdgesAndVerticesCrossEvenly) {
  // Lattice lines meet the vertices, edges and coplanar faces of boxes on the same lattice.
  TriangleMesh m = test::box({0, 0, 0}, {4, 4, 4});
  append(m, test::box({1, 1, 1}, {3, 3, 3}), true);
  const MeshQuery query(m);
  std::vector<MeshQuery::Hit> hits;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = -1; i <= 10; ++i)
      for (int j = -1; j <= 10; ++j) {
        Vector3d a, b;
        a[axis] = -1.0;
        b[axis] = 9.0;
        a[(axis + 1) % 3] = b[(axis + 1) % 3] = 0.5 * i;
        a[(axis + 2) % 3] = b[(axis + 2) % 3] = 0.5 * j;
        query.hits(a, b, hits);
        EXPECT_EQ(hits.size() % 2, 0u) << axis << ' ' << i << ' ' << j;
      }
  // The middle line: in at 0, out at 1, in at 3, out at 4.
  query.hits({-1, 2.2, 2.1}, {9, 2.2, 2.1}, hits);
  ASSERT_EQ(hits.size(), 4u);
  const double expected[] = {0.1, 0.2, 0.4, 0.5};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(hits[i].t, expected[i], 1e-15);
}

TEST(MeshQuery, LinesThroughSphereVerticesCrossEvenly) {
  const TriangleMesh m = test::sphere({0.1, 0.2, 0.3}, 10.0, 20);
  const MeshQuery query(m);
  std::mt19937 random(5);
  std::uniform_int_distribution<std::size_t> vertex(0, m.vertices.size() - 1);
  std::vector<MeshQuery::Hit> hits;
  for (int i = 0; i < 5000; ++i) {
    // Through two vertices, or through a vertex along an axis.
    const Vector3d p = m.vertices[vertex(random)];
    const Vector3d d = i % 4 == 3 ? Vector3d(m.vertices[vertex(random)] - p)
                                  : Vector3d(50.0 * Vector3d::Unit(i % 4));
    if (d.norm() < 1e-9)
      continue;
    const Vector3d step = 50.0 * d.normalized();
    query.hits(p - step, p + step, hits);
    EXPECT_EQ(hits.size() % 2, 0u) << i;
  }
}

TEST(MeshQuery, FirstHitIsTheFirstOfAll) {
  std::mt19937 random(6);
  const TriangleMesh m = soup(random, 400);
  const MeshQuery query(m);
  std::uniform_real_distribution<double> at(-15.0, 15.0);
  std::vector<MeshQuery::Hit> hits;
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const Vector3d a(at(random), at(random), at(random)), b(at(random), at(random), at(random));
    query.hits(a, b, hits);
    // Every triangle by Cramer's rule.
    std::size_t expected = 0;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      Eigen::Matrix3d system;
      system << m.corner(t, 1) - m.corner(t, 0), m.corner(t, 2) - m.corner(t, 0), a - b;
      const Vector3d x = system.inverse() * (a - m.corner(t, 0));
      if (x[0] >= 0 && x[1] >= 0 && x[0] + x[1] <= 1 && x[2] >= 0 && x[2] <= 1)
        ++expected;
    }
    EXPECT_EQ(hits.size(), expected);
    const auto first = query.firstHit(a, b);
    ASSERT_EQ(first.has_value(), !hits.empty());
    if (first) {
      ++found;
      EXPECT_EQ(first->triangle, hits.front().triangle);
      EXPECT_EQ(first->t, hits.front().t);
    }
  }
  EXPECT_GT(found, 100);
}
