// Waypoints that a straight bead does not need.
#include "base/units.h"
#include "toolpath/idle_waypoints.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::toolpath {
namespace {
using Eigen::Vector3d;

constexpr double kChordMm = 0.005, kLongMm = 10.0;
constexpr float kWidthMm = 0.5F;
const double kLongestMm = 6.0 * static_cast<double>(kWidthMm);

void addWaypoint(plan::ToolPlan& plan, const Vector3d& position, float width = kWidthMm,
                 float speed = 20.0F) {
  plan.position.push_back(position);
  plan.direction.emplace_back(Vector3d::UnitZ());
  plan.widthMm.push_back(width);
  plan.heightMm.push_back(0.2F);
  plan.speedMmPerS.push_back(speed);
}

plan::ToolPlan onePath(plan::ToolPlan plan) {
  plan.paths = {{.first = 0, .count = plan.waypointCount()}};
  return plan;
}

plan::ToolPlan thinned(const plan::ToolPlan& plan) {
  return withoutIdleWaypoints(onePath(plan), kChordMm, kLongMm);
}

double volumeMm3(const plan::ToolPlan& plan) {
  double sum = 0.0;
  for (std::size_t i = 1; i < plan.waypointCount(); ++i)
    sum += (plan.position[i] - plan.position[i - 1]).norm() * 0.5 *
           static_cast<double>(plan.widthMm[i] + plan.widthMm[i - 1]) * 0.2;
  return sum;
}

TEST(IdleWaypoints, ALineKeepsItsEndsAndTheLongestSteps) {
  plan::ToolPlan line;
  for (int i = 0; i <= 120; ++i)
    addWaypoint(line, {0.1 * i, 0.0, 0.2});
  const plan::ToolPlan thin = thinned(line);
  EXPECT_EQ(thin.waypointCount(), 5U); // 12 mm in steps of 3
  EXPECT_EQ(thin.position.front(), line.position.front());
  EXPECT_EQ(thin.position.back(), line.position.back());
  EXPECT_EQ(thin.paths.front().count, 5U);
  EXPECT_EQ(withoutIdleWaypoints(onePath(line), kChordMm, 2.0).waypointCount(), 7U);
}

TEST(IdleWaypoints, CornersWidthsSpeedsAndDirectionsStay) {
  plan::ToolPlan plan;
  addWaypoint(plan, {0, 0, 0});
  addWaypoint(plan, {1, 0, 0});
  addWaypoint(plan, {1, 1, 0}); // corner at 1
  addWaypoint(plan, {1, 2, 0}, 0.6F);
  addWaypoint(plan, {1, 3, 0}, 0.6F);        // wider from 3 on
  addWaypoint(plan, {1, 4, 0}, 0.6F, 10.0F); // slower from 4 to 5
  addWaypoint(plan, {1, 5, 0}, 0.6F, 20.0F);
  addWaypoint(plan, {1, 6, 0}, 0.6F, 20.0F);
  plan.direction.back() = Vector3d(0.0, 0.01, 1.0).normalized();
  EXPECT_EQ(thinned(plan).waypointCount(), plan.waypointCount());
  EXPECT_FALSE(hasOneDirection(plan));
  plan.direction.back() = Vector3d::UnitZ();
  EXPECT_TRUE(hasOneDirection(plan));
  EXPECT_EQ(thinned(plan).waypointCount(), plan.waypointCount() - 1);
}

TEST(IdleWaypoints, ACircleStaysWithinItsChord) {
  constexpr double kRadiusMm = 5.0;
  plan::ToolPlan circle;
  for (int i = 0; i <= 3000; ++i)
    addWaypoint(circle, {kRadiusMm * std::cos(base::kPi * i / 1500.0),
                         kRadiusMm * std::sin(base::kPi * i / 1500.0), 0.0});
  const plan::ToolPlan thin = thinned(circle);
  // A chord of half angle a is r (1 - cos a) from its arc.
  const double half = std::acos(1.0 - kChordMm / kRadiusMm);
  EXPECT_NEAR(static_cast<double>(thin.waypointCount() - 1), base::kPi / half, 2.0);
  for (std::size_t i = 1; i < thin.waypointCount(); ++i)
    EXPECT_GE((0.5 * (thin.position[i] + thin.position[i - 1])).norm(),
              kRadiusMm - kChordMm - 1e-9);
}

TEST(IdleWaypoints, PathsWithoutPlasticAndTheirOrderStay) {
  plan::ToolPlan plan;
  for (int i = 0; i < 5; ++i)
    addWaypoint(plan, {0.1 * i, 0.0, 0.0});
  for (int i = 0; i < 5; ++i)
    addWaypoint(plan, {0.1 * i, 1.0, 0.0});
  plan.paths = {{.first = 0, .count = 5, .kind = plan::PathKind::Tape, .layer = 3},
                {.first = 5, .count = 5, .kind = plan::PathKind::Infill, .layer = 4}};
  const plan::ToolPlan thin = withoutIdleWaypoints(plan, kChordMm, kLongMm);
  ASSERT_EQ(thin.paths.size(), 2U);
  EXPECT_EQ(thin.paths[0].count, 5U);
  EXPECT_EQ(thin.paths[1].first, 5U);
  EXPECT_EQ(thin.paths[1].count, 2U);
  EXPECT_EQ(thin.paths[1].layer, 4);
}

TEST(IdleWaypoints, RandomLinesKeepTheirCourseAndVolume) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(0.05, 1.0), bend(-0.3, 0.3), noise(-0.002, 0.002);
  for (int line = 0; line < 200; ++line) {
    plan::ToolPlan plan;
    Vector3d at(0.0, 0.0, 0.2);
    double heading = 0.0;
    for (int i = 0; i < 60; ++i) {
      addWaypoint(plan, at + Vector3d(noise(random), noise(random), 0.0),
                  kWidthMm * static_cast<float>(1.0 + 0.2 * std::sin(0.1 * i)));
      if (i % 7 == line % 7)
        heading += bend(random);
      at += step(random) * Vector3d(std::cos(heading), std::sin(heading), 0.0);
    }
    const plan::ToolPlan thin = thinned(plan);
    EXPECT_LT(thin.waypointCount(), plan.waypointCount());
    EXPECT_NEAR(volumeMm3(thin) / volumeMm3(plan), 1.0, 0.005);
    for (std::size_t i = 1; i < thin.waypointCount(); ++i) {
      const Vector3d &a = thin.position[i - 1], &b = thin.position[i];
      const auto from = std::ranges::find(plan.position, a),
                 to = std::ranges::find(plan.position, b);
      EXPECT_TRUE((b - a).norm() <= 1.4 * kLongestMm || to == from + 1);
      for (auto p = from; p != to; ++p) {
        const double share = (*p - a).dot(b - a) / (b - a).squaredNorm();
        EXPECT_LE((*p - a - share * (b - a)).norm(), kChordMm + 1e-9);
      }
    }
  }
}

} // namespace
} // namespace voluta::toolpath
