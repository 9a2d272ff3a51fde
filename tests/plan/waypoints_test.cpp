#include "plan/waypoints.h"

#include <gtest/gtest.h>

using namespace voluta::plan;

TEST(Waypoints, AreOfThePathTheyLieIn) {
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
