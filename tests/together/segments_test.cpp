// Where a motion is cut.
#include "together/segments.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::together {
namespace {

// Beads of a few points each, with a lift, a travel and a way down between them.
plan::Trajectory beads(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> length(1, 6), travel(1, 5);
  std::uniform_real_distribution<double> seconds(0.1, 2.0);
  plan::Trajectory t;
  t.dof = 1;
  double now = 0.0;
  std::size_t waypoint = 0;
  const auto add = [&](plan::MoveKind kind, bool isWaypoint) {
    t.joints.push_back(now);
    t.timeS.push_back(now);
    t.move.push_back(kind);
    t.waypoint.push_back(isWaypoint ? waypoint++ : plan::kNoWaypoint);
    t.extrudedMm3.push_back(0.0);
    now += seconds(random);
  };
  add(plan::MoveKind::Joint, false);
  for (std::size_t bead = 0; bead < count; ++bead) {
    for (int k = travel(random); k > 0; --k)
      add(plan::MoveKind::Joint, false);
    add(plan::MoveKind::Linear, true);
    for (int k = length(random); k > 0; --k)
      add(plan::MoveKind::Print, true);
    add(plan::MoveKind::Linear, false);
  }
  add(plan::MoveKind::Joint, false);
  return t;
}

TEST(Segments, RestsAreLiftedAndCoverTheMotion) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const plan::Trajectory t = beads(seed, 1 + seed % 12);
    const Rests rests = restsOf(t, 1000);
    ASSERT_GE(rests.point.size(), 2u);
    EXPECT_EQ(rests.point.front(), 0u);
    EXPECT_EQ(rests.point.back(), t.pointCount() - 1);
    double sum = 0.0;
    const std::vector<double> seconds = secondsOf(t, rests);
    for (std::size_t i = 0; i < rests.segments(); ++i) {
      EXPECT_LT(rests.point[i], rests.point[i + 1]);
      sum += seconds[i];
    }
    EXPECT_NEAR(sum, t.timeS.back(), 1e-9);
    for (std::size_t i = 1; i + 1 < rests.point.size(); ++i) {
      const std::size_t p = rests.point[i];
      EXPECT_NE(t.move[p], plan::MoveKind::Print);
      EXPECT_NE(t.move[p + 1], plan::MoveKind::Print) << "on a bead";
      EXPECT_EQ(t.waypoint[p], plan::kNoWaypoint);
    }
    EXPECT_EQ(rests.filledFrom.front(), 0u);
    for (std::size_t i = 1; i < rests.point.size(); ++i) {
      std::size_t printed = 0;
      for (std::size_t p = 0; p <= rests.point[i]; ++p)
        if (t.move[p] == plan::MoveKind::Print)
          printed = t.waypoint[p] + 1;
      EXPECT_EQ(rests.filledFrom[i], printed);
    }
  }
}

TEST(Segments, WaitsCountInTheSegmentThatTheyBegin) {
  plan::Trajectory t = beads(3, 4);
  const Rests rests = restsOf(t, 1000);
  const std::vector<double> before = secondsOf(t, rests);
  t.events = {{.point = rests.point[2] + 1, .kind = plan::EventKind::Wait, .seconds = 7.0}};
  const std::vector<double> after = secondsOf(t, rests);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(after[i] - before[i], i == 2 ? 7.0 : 0.0, 1e-9);
}

TEST(Segments, AreNoMoreThanWanted) {
  const plan::Trajectory t = beads(5, 200);
  EXPECT_LE(restsOf(t, 20).segments(), 21u);
  EXPECT_GE(restsOf(t, 20).segments(), 8u);
}

TEST(Segments, ALongBeadCanBeInterrupted) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const plan::Trajectory t = beads(seed, 1 + seed % 5);
    constexpr double kApartS = 3.0;
    const Rests rests = restsOf(t, 1000, kApartS), lifted = restsOf(t, 1000);
    EXPECT_TRUE(std::ranges::includes(rests.point, lifted.point));
    for (std::size_t i = 1; i + 1 < rests.point.size(); ++i) {
      const std::size_t p = rests.point[i];
      if (t.move[p] != plan::MoveKind::Print)
        continue;
      EXPECT_EQ(t.move[p + 1], plan::MoveKind::Print);
      EXPECT_GE(t.timeS[p] - t.timeS[rests.point[i - 1]], kApartS);
      EXPECT_EQ(rests.filledFrom[i], t.waypoint[p] + 1);
    }
    // Within beads there is no longer segment than that and the motion to one point.
    for (std::size_t i = 0; i < rests.segments(); ++i)
      for (std::size_t p = rests.point[i] + 1; p < rests.point[i + 1]; ++p)
        if (t.move[p] == plan::MoveKind::Print && t.move[p + 1] == plan::MoveKind::Print) {
          EXPECT_LT(t.timeS[p] - t.timeS[rests.point[i]], kApartS);
        }
  }
}

} // namespace
} // namespace voluta::together
