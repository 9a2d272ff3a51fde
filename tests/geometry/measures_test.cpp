#include "geometry/measures.h"

#include "base/units.h"
#include "geometry/edges.h"
#include "helpers/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

using namespace voluta;
using Eigen::Vector3d;

TEST(Measures, Box) {
  const auto m = test::box({1, 2, 3}, {3, 5, 7});
  EXPECT_NEAR(geometry::volume(m), 24.0, 1e-12);
  EXPECT_NEAR(geometry::area(m), 2 * (6 + 8 + 12), 1e-12);
  EXPECT_EQ(geometry::bounds(m).min(), Vector3d(1, 2, 3));
  EXPECT_EQ(geometry::bounds(m).max(), Vector3d(3, 5, 7));
}

TEST(Measures, SphereTendsToClosedForm) {
  const auto m = test::sphere({5, 5, 5}, 10.0, 90);
  EXPECT_NEAR(geometry::volume(m) / (4.0 / 3.0 * base::kPi * 1000.0), 1.0, 2e-3);
  EXPECT_NEAR(geometry::area(m) / (400.0 * base::kPi), 1.0, 2e-3);
  const auto normals = geometry::vertexNormals(m);
  for (std::size_t v = 0; v < normals.size(); ++v)
    EXPECT_GT(normals[v].dot((m.vertices[v] - Vector3d(5, 5, 5)).normalized()), 0.999);
}

TEST(Measures, InsideOutIsNegative) {
  auto m = test::box({0, 0, 0}, {1, 1, 1});
  for (auto& t : m.triangles)
    std::swap(t[0], t[1]);
  EXPECT_NEAR(geometry::volume(m), -1.0, 1e-12);
}

TEST(Measures, EmptyMesh) {
  const geometry::TriangleMesh m;
  EXPECT_EQ(geometry::volume(m), 0.0);
  EXPECT_TRUE(geometry::bounds(m).isEmpty());
  EXPECT_EQ(geometry::components(m).count, 0);
}

TEST(Measures, ComponentsAndSubMesh) {
  auto m = test::box({0, 0, 0}, {1, 1, 1});
  const auto other = test::box({5, 0, 0}, {7, 1, 1});
  for (const auto& t : other.triangles)
    m.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  m.vertices.insert(m.vertices.end(), other.vertices.begin(), other.vertices.end());
  const auto parts = geometry::components(m);
  ASSERT_EQ(parts.count, 2);
  std::vector<bool> keep(m.triangles.size());
  for (std::size_t t = 0; t < keep.size(); ++t)
    keep[t] = parts.ofTriangle[t] == 1;
  const auto second = geometry::subMesh(m, keep);
  EXPECT_EQ(second.vertices.size(), 8u);
  EXPECT_NEAR(geometry::volume(second), 2.0, 1e-12);
}

TEST(SortedHalfEdges, AreThoseOfSomeTrianglesInOrder) {
  // Two fans, so that some vertices have many sides and others few.
  geometry::TriangleMesh mesh;
  mesh.vertices.resize(60);
  for (int v = 59; v > 2; --v)
    mesh.triangles.push_back({0, v, v - 1});
  for (int v = 2; v < 59; ++v)
    mesh.triangles.push_back({v + 1, 1, v});
  std::vector<int> some;
  std::set<std::array<int, 4>> expected;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    if (t % 3 == 1)
      continue;
    some.push_back(t);
    const auto& corner = mesh.triangles[static_cast<std::size_t>(t)];
    for (std::size_t side = 0; side < 3; ++side) {
      const auto [low, high] = std::minmax(corner[side], corner[(side + 1) % 3]);
      expected.insert({low, high, t, static_cast<int>(side)});
    }
  }
  const auto edges = geometry::sortedHalfEdges(mesh, some);
  ASSERT_EQ(edges.size(), expected.size());
  auto next = expected.begin();
  for (const geometry::HalfEdge& e : edges) {
    EXPECT_EQ((std::array<int, 4>{e.low, e.high, e.triangle, e.side}), *next++);
    const auto& corner = mesh.triangles[static_cast<std::size_t>(e.triangle)];
    EXPECT_EQ(e.forward, corner[static_cast<std::size_t>(e.side)] == e.low);
  }
  EXPECT_EQ(geometry::sortedHalfEdges(mesh).size(), 3 * mesh.triangles.size());
}
