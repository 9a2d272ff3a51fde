// The order of beads in which those below have cooled longest: rings and walls in closed form, and
// random plans of which no bead may change but its place, its sense and its beginning.
#include "toolpath/order/order_to_cool.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::toolpath {
namespace {

constexpr double kHeight = 0.8;

void add(Assembled& to, const std::vector<Eigen::Vector3d>& points, int layer, bool closed) {
  plan::ToolPath path;
  path.first = to.plan.waypointCount();
  path.count = points.size();
  path.layer = path.patch = layer;
  path.closed = closed;
  for (std::size_t k = 0; k < points.size(); ++k) {
    to.plan.position.push_back(points[k]);
    to.plan.direction.push_back(Eigen::Vector3d::UnitZ());
    to.plan.widthMm.push_back(1.2F);
    to.plan.heightMm.push_back(static_cast<float>(kHeight));
    to.plan.speedMmPerS.push_back(10.0F);
    to.clearDirection.push_back(Eigen::Vector3d::UnitZ());
  }
  to.plan.paths.push_back(path);
}

std::vector<Eigen::Vector3d> ring(double radius, int layer, double fromRad) {
  constexpr int kPoints = 90;
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k <= kPoints; ++k) {
    const double angle = fromRad + 2.0 * base::kPi * (k % kPoints) / kPoints;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), (layer + 1) * kHeight);
  }
  return points;
}
double radiusOf(const Assembled& made, std::size_t path) {
  return made.plan.position[made.plan.paths[path].first].head<2>().norm();
}
double angleOf(const Assembled& made, std::size_t path) {
  const Eigen::Vector3d& p = made.plan.position[made.plan.paths[path].first];
  return std::atan2(p.y(), p.x());
}

// For any initial order and seams, every layer has those of the first.
TEST(OrderToCool, RingsKeepTheirOrderAndSeams) {
  std::mt19937 random(11);
  for (int seed = 0; seed < 100; ++seed) {
    Assembled made;
    for (int layer = 0; layer < 6; ++layer) {
      std::vector<double> radii = {8.0, 12.0, 16.0};
      std::ranges::shuffle(radii, random);
      for (const double radius : radii)
        add(made, ring(radius, layer, 0.01 * static_cast<double>(random() % 628)), layer, true);
    }
    const std::size_t waypoints = made.plan.waypointCount();
    orderToCool(made, true);
    ASSERT_EQ(made.plan.paths.size(), 18u);
    ASSERT_EQ(made.plan.waypointCount(), waypoints);
    for (std::size_t p = 3; p < 18; ++p) {
      EXPECT_NEAR(radiusOf(made, p), radiusOf(made, p - 3), 1e-6);
      // Within two points of the ring.
      EXPECT_LT(std::abs(std::remainder(angleOf(made, p) - angleOf(made, p - 3), 2.0 * base::kPi)),
                2.5 * 2.0 * base::kPi / 90.0);
    }
  }
}

TEST(OrderToCool, SeamsStayAtTheirPlaces) {
  Assembled made;
  for (int layer = 0; layer < 4; ++layer)
    add(made, ring(12.0, layer, 0.7 * layer), layer, true);
  const std::vector<Eigen::Vector3d> before = made.plan.position;
  orderToCool(made, false);
  EXPECT_EQ(made.plan.position, before);
}

TEST(OrderToCool, WallsRunInOneDirection) {
  Assembled made;
  for (int layer = 0; layer < 4; ++layer) {
    std::vector<Eigen::Vector3d> wall;
    for (int k = 0; k <= 30; ++k)
      wall.emplace_back(k, 0.0, (layer + 1) * kHeight);
    if (layer % 2)
      std::ranges::reverse(wall);
    add(made, wall, layer, false);
    for (std::size_t w = made.plan.paths.back().first + 1; w < made.plan.waypointCount(); ++w)
      made.plan.speedMmPerS[w] =
          made.plan.position[w].x() > 14.9 && made.plan.position[w - 1].x() > 14.9 ? 5.0F : 10.0F;
  }
  orderToCool(made, true);
  for (const plan::ToolPath& path : made.plan.paths) {
    EXPECT_EQ(made.plan.position[path.first].x(), 0.0);
    for (std::size_t k = 1; k < path.count; ++k)
      EXPECT_EQ(made.plan.speedMmPerS[path.first + k], k > 15 ? 5.0F : 10.0F)
          << "the slow half stays slow";
  }
}

TEST(OrderToCool, KindsKeepTheirTurns) {
  Assembled made;
  for (int layer = 0; layer < 3; ++layer)
    for (const plan::PathKind kind :
         {plan::PathKind::Wall, plan::PathKind::Infill, plan::PathKind::GapFill}) {
      add(made, ring(10.0 + 2.0 * static_cast<double>(kind), layer, 0.0), layer, true);
      made.plan.paths.back().kind = kind;
    }
  orderToCool(made, true);
  for (std::size_t p = 0; p < made.plan.paths.size(); ++p)
    EXPECT_EQ(static_cast<std::size_t>(made.plan.paths[p].kind), p % 3);
}

// Returns the total time of a plan of closed rings of one width, each begun as soon as all rings
// below it are that old; they have one seam. Without travel.
double timeWithWaits(const Assembled& made, double minS) {
  constexpr double kCovers = 0.75 * 1.2; // maximum distance of a ring from one that it covers
  std::vector<double> begins;
  double now = 0.0;
  for (std::size_t p = 0; p < made.plan.paths.size(); ++p) {
    const plan::ToolPath& path = made.plan.paths[p];
    for (std::size_t q = 0; q < p; ++q)
      if (made.plan.paths[q].layer + 1 == path.layer &&
          std::abs(radiusOf(made, p) - radiusOf(made, q)) < kCovers)
        now = std::max(now, begins[q] + minS);
    begins.push_back(now);
    for (std::size_t k = path.first + 1; k < path.first + path.count; ++k)
      now += (made.plan.position[k] - made.plan.position[k - 1]).norm() / 10.0;
  }
  return now;
}

// Cones of an outer wall, an infill and an inner wall, which each cover their neighbour below: a
// layer needs hardly more than the least time, for either direction in which the walls lean.
TEST(OrderToCool, ConesNeedOneMinimumTimeALayer) {
  constexpr int kLayers = 20;
  constexpr double kMinS = 60.0;
  for (const double step : {-0.6, 0.0, 0.6}) {
    SCOPED_TRACE(step);
    Assembled made;
    for (int layer = 0; layer < kLayers; ++layer) {
      const double outer = 20.0 + step * layer;
      const std::pair<double, plan::PathKind> rings[] = {{outer, plan::PathKind::Wall},
                                                         {outer - 2.4, plan::PathKind::Infill},
                                                         {outer - 1.2, plan::PathKind::Wall}};
      for (const auto& [radius, kind] : rings) {
        add(made, ring(radius, layer, 0.0), layer, true);
        made.plan.paths.back().kind = kind;
        made.plan.paths.back().ring = radius < outer - 1.0 ? 1 : 0;
      }
    }
    Assembled inTurns = made;
    orderToCool(inTurns, true);
    orderToCool(made, true, kMinS);
    const double bound = (kLayers - 1) * kMinS + 3.0 * 2.0 * base::kPi * 20.0 / 10.0;
    EXPECT_LE(timeWithWaits(made, kMinS), 1.05 * bound);
    EXPECT_LE(timeWithWaits(made, kMinS), timeWithWaits(inTurns, kMinS) + 1e-6);
    EXPECT_EQ(made.plan.waypointCount(), inTurns.plan.waypointCount());
    if (step != 0.0) {
      EXPECT_GT(timeWithWaits(inTurns, kMinS), 1.2 * bound) << "it matters";
    }
  }
}

} // namespace
} // namespace voluta::toolpath
