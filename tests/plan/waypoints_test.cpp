#include "plan/waypoints.h"

#include <gtest/gtest.h>

using namespace voluta::plan;

TEST(Waypoints, PathOfFindsThePathOfAWaypoint) {
  ToolPlan plan;
  plan.position.resize(7);
  plan.paths = {{0, 3}, {3, 4}};
  for (std::size_t w = 0; w < 7; ++w)
    EXPECT_EQ(pathOf(plan, w), &plan.paths[w < 3 ? 0 : 1]) << w;
  EXPECT_EQ(pathOf(plan, 7), nullptr);
  EXPECT_EQ(pathOf({}, 0), nullptr);
}

TEST(Waypoints, APointLeadsToTheNextOne) {
  Trajectory t;
  t.waypoint = {kNoWaypoint, 4, kNoWaypoint, kNoWaypoint, 5, kNoWaypoint};
  t.timeS.resize(t.waypoint.size());
  const std::size_t ahead[] = {4, 4, 5, 5, 5, kNoWaypoint};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(waypointAhead(t, i), ahead[i]) << i;
}

TEST(Waypoints, PathContinuesAfterSkippedWaypoints) {
  ToolPlan plan;
  for (int i = 0; i < 12; ++i) {
    plan.position.emplace_back(i, 0, 0);
    plan.direction.emplace_back(Eigen::Vector3d::UnitZ());
    plan.widthMm.push_back(static_cast<float>(i));
    plan.heightMm.push_back(static_cast<float>(-i));
    plan.speedMmPerS.push_back(static_cast<float>(2 * i));
  }
  plan.paths = {{0, 7}, {7, 5}};
  plan.paths[0].layer = 3;
  plan.paths[1].closed = true;
  // The fourth remains alone between two removed ones, and is removed with them.
  plan.fill = {{1.5, 2.5}};
  const RestOfPlan rest = without(plan, {0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(rest.plan.fillOf(0).shellMm, 1.5);
  EXPECT_EQ(rest.plan.fillOf(0).openMm3, 2.5);
  EXPECT_EQ(rest.waypoint, (std::vector<std::size_t>{0, 1, 5, 6, 7, 8, 9, 10, 11}));
  ASSERT_EQ(rest.plan.paths.size(), 3u);
  EXPECT_EQ(rest.plan.paths[1].first, 2u);
  EXPECT_EQ(rest.plan.paths[1].count, 2u);
  EXPECT_EQ(rest.plan.paths[1].layer, 3);
  EXPECT_TRUE(rest.plan.paths[2].closed);
  for (std::size_t i = 0; i < rest.waypoint.size(); ++i) {
    EXPECT_EQ(rest.plan.position[i], plan.position[rest.waypoint[i]]);
    EXPECT_EQ(rest.plan.widthMm[i], plan.widthMm[rest.waypoint[i]]);
    EXPECT_EQ(rest.plan.heightMm[i], plan.heightMm[rest.waypoint[i]]);
    EXPECT_EQ(rest.plan.speedMmPerS[i], plan.speedMmPerS[rest.waypoint[i]]);
  }
  // A ring that is cut is one no more.
  EXPECT_FALSE(without(plan, {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}).plan.paths[1].closed);
}
