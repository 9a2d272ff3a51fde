// Waypoints left out of a motion, round by round.
#include "pipeline/avoided.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace voluta;

namespace {

using Waypoints = std::vector<std::size_t>;

// Two paths of 40 waypoints each.
plan::ToolPlan twoPaths() {
  plan::ToolPlan plan;
  plan.position.resize(80);
  plan.direction.resize(80);
  plan.widthMm.resize(80);
  plan.heightMm.resize(80);
  plan.speedMmPerS.resize(80);
  for (std::size_t first : {0, 40}) {
    plan.paths.emplace_back();
    plan.paths.back().first = first;
    plan.paths.back().count = 40;
  }
  return plan;
}

} // namespace

TEST(Avoided, EachOnceAndNothingBesides) {
  pipeline::Avoided avoided;
  EXPECT_EQ(avoided.next(twoPaths(), {30, 7, 8, 30}), (Waypoints{7, 8, 30}));
  EXPECT_EQ(avoided.next(twoPaths(), {8, 50, 20}), (Waypoints{20, 50}));
  EXPECT_TRUE(avoided.next(twoPaths(), {7, 50}).empty());
}

// The path resumes further and further behind the waypoints left out, as long as the nozzle
// collides there.
TEST(Avoided, MoreWaypointsAreSkippedBesideSkippedOnes) {
  pipeline::Avoided avoided;
  const plan::ToolPlan plan = twoPaths();
  EXPECT_EQ(avoided.next(plan, {10}), (Waypoints{10}));
  EXPECT_EQ(avoided.next(plan, {11}), (Waypoints{11, 12}));
  EXPECT_EQ(avoided.next(plan, {13}), (Waypoints{13, 14, 15, 16}));
  EXPECT_EQ(avoided.next(plan, {9}), (Waypoints{2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(avoided.next(plan, {17, 60}).back(), 60u); // alone
}

TEST(Avoided, NotBeyondThePath) {
  pipeline::Avoided avoided;
  const plan::ToolPlan plan = twoPaths();
  avoided.next(plan, {37, 41});
  avoided.next(plan, {});
  EXPECT_EQ(avoided.next(plan, {38, 40}), (Waypoints{38, 39, 40}));
}

// As if every waypoint of the path met as soon as it is where the path begins: a path of any length
// is left out whole in six rounds or less.
TEST(Avoided, EndsInAFewRounds) {
  plan::ToolPlan plan = twoPaths();
  plan.paths.resize(1);
  plan.paths.front().count = 80;
  pipeline::Avoided avoided;
  std::vector<char> out(80, 0);
  std::size_t begins = 5;
  out[4] = 1;
  avoided.next(plan, {4});
  int rounds = 0;
  for (; begins < 80; ++rounds) {
    for (const std::size_t i : avoided.next(plan, {begins}))
      out[i] = 1;
    begins = static_cast<std::size_t>(std::find(out.begin() + 5, out.end(), 0) - out.begin());
  }
  EXPECT_LE(rounds, 6);
}
