// The block's columns: against a ball at many positions, and as a surface.
#include "milling/block_mesh.h"
#include "milling/height_map.h"
#include "milling/stock.h"

#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "helpers/shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace voluta::milling {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// The height that a ball leaves over a place, at the lowest of many positions on its way.
double lowestBall(double radius, const Vector3d& from, const Vector3d& to, const Vector2d& place) {
  constexpr int kPositions = 500;
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kPositions; ++i) {
    const Vector3d tip = from + (to - from) * i / kPositions;
    const double square = radius * radius - (place - tip.head<2>()).squaredNorm();
    if (square >= 0.0)
      lowest = std::min(lowest, tip.z() + radius - std::sqrt(square));
  }
  return lowest;
}

TEST(Stock, BallRemovesItsSweptVolume) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> across(-4.0, 4.0), height(1.0, 9.0);
  for (int k = 0; k < 10; ++k) {
    const Vector3d from(across(random), across(random), height(random));
    Vector3d to(across(random), across(random), height(random));
    if (k % 5 == 0)
      to.head<2>() = from.head<2>(); // straight up or down
    if (k % 5 == 1)
      to.y() = from.y(); // along the cells
    const Cutter cutter{3.0, 1};
    Stock stock({Vector3d(-6, -6, 0), Vector3d(6, 6, 8)}, 0.5);
    stock.cut(cutter, from, to);
    for (int j = 0; j < stock.grid().countY; ++j)
      for (int i = 0; i < stock.grid().countX; ++i) {
        const double left = stock.highAt(stock.grid().index(i, j)),
                     ball = std::min(8.0, lowestBall(1.5, from, to, stock.grid().middle(i, j)));
        ASSERT_LE(left, ball + 1e-9) << k;
        // Near the edge of the sweep the ball is steep, and positions are few.
        ASSERT_GE(left, ball - 0.3) << k;
      }
  }
}

TEST(Stock, HasASurfaceOfItsVolume) {
  Stock stock({Vector3d(0, 0, 0), Vector3d(10, 8, 5)}, 0.1);
  const double whole = geometry::volume(meshOf(stock, 1000000));
  EXPECT_NEAR(whole, 9.9 * 7.9 * 5.0, 1e-6); // between the middles of the outer columns
  const double removed = stock.cut(Cutter{2.0, 1}, {3, 4, 3}, {7, 4, 3});
  EXPECT_NEAR(whole - geometry::volume(meshOf(stock, 1000000)), removed, 1e-6);
  const auto coarse = meshOf(stock, 400);
  EXPECT_LT(coarse.vertices.size(), 900u);
  EXPECT_NEAR(geometry::volume(coarse), whole - removed, 0.15 * whole);
}

TEST(HeightMap, IsThatOfRaysFromAbove) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-5.0, 5.0);
  geometry::TriangleMesh parts;
  for (int k = 0; k < 6; ++k) { // boxes, some of which overlap
    const Vector3d a(coordinate(random), coordinate(random), coordinate(random)),
        b(coordinate(random), coordinate(random), coordinate(random));
    const geometry::TriangleMesh one = test::box(a.cwiseMin(b), a.cwiseMax(b));
    const int first = static_cast<int>(parts.vertices.size());
    const Eigen::AngleAxisd rotation(coordinate(random), Vector3d(1, 2, 3).normalized());
    for (const Vector3d& v : one.vertices)
      parts.vertices.push_back(rotation * v);
    for (const auto& [p, q, r] : one.triangles)
      parts.triangles.push_back({p + first, q + first, r + first});
  }
  const HeightMap map = heightMap(parts, gridOver({-8, -8}, {8, 8}, 0.23), {});
  const geometry::MeshQuery query(parts, geometry::MeshQuery::Of::Surface);
  std::size_t part = 0;
  for (int j = 0; j < map.grid.countY; ++j)
    for (int i = 0; i < map.grid.countX; ++i) {
      const Vector2d at = map.grid.middle(i, j);
      const double high = 20.0, low = -20.0;
      const auto hit = query.firstHit({at.x(), at.y(), high}, {at.x(), at.y(), low});
      const std::size_t cell = map.grid.index(i, j);
      ASSERT_EQ(hit.has_value(), map.isPart(cell)) << at.transpose();
      if (!hit)
        continue;
      EXPECT_NEAR(high + hit->t * (low - high), map.top[cell], 1e-6);
      ++part;
    }
  EXPECT_GT(part, 1000u);
}

} // namespace
} // namespace voluta::milling
