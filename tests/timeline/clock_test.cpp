#include "timeline/clock.h"

#include "base/error.h"
#include "timeline/sample_program.h"

#include <gtest/gtest.h>

namespace voluta::timeline {
namespace {

using test::sampleProgram;

// 3 layers of 4 waypoints: points 0 T, 1-4 layer 0, 5 T, 6-9 layer 1, 10 T, 11-14 layer 2.
Clock smallClock() {
  const test::SampleProgram p = sampleProgram(3, 4);
  return Clock(p.trajectory, p.toolPlan);
}

TEST(Clock, AnEmptyOneLastsNoTime) {
  const Clock clock;
  EXPECT_TRUE(clock.empty());
  EXPECT_EQ(clock.durationS(), 0.0);
  EXPECT_THROW(clock.pointAt(0.0), base::Error);
}

TEST(Clock, FindsThePointReached) {
  const Clock clock = smallClock();
  EXPECT_DOUBLE_EQ(clock.durationS(), 14.0);
  EXPECT_EQ(clock.pointAt(-1.0), 0u);
  EXPECT_EQ(clock.pointAt(0.0), 0u);
  EXPECT_EQ(clock.pointAt(2.999), 2u);
  EXPECT_EQ(clock.pointAt(3.0), 3u);
  EXPECT_EQ(clock.pointAt(99.0), 14u);
}

TEST(Clock, JointsAreLinearBetweenPoints) {
  const Clock clock = smallClock();
  for (const double t : {0.0, 0.25, 2.5, 7.75, 14.0}) {
    const double a = std::floor(t), share = t - a;
    const robot::JointVector q = clock.jointsAt(t);
    ASSERT_EQ(q.size(), 6);
    for (int j = 0; j < 6; ++j)
      EXPECT_NEAR(q[j],
                  (1.0 - share) * std::sin(0.1 * a + j) + share * std::sin(0.1 * (a + 1.0) + j),
                  1e-12);
  }
  EXPECT_EQ(clock.jointsAt(-5.0), clock.jointsAt(0.0));
  EXPECT_EQ(clock.jointsAt(50.0), clock.jointsAt(14.0));
}

TEST(Clock, CountsPrintedWaypoints) {
  const Clock clock = smallClock();
  EXPECT_EQ(clock.printedWaypoints(0.5), 0u);
  EXPECT_EQ(clock.printedWaypoints(1.0), 1u);
  EXPECT_EQ(clock.printedWaypoints(4.9), 4u);
  EXPECT_EQ(clock.printedWaypoints(5.5), 4u); // travelling
  EXPECT_EQ(clock.printedWaypoints(6.0), 5u);
  EXPECT_EQ(clock.printedWaypoints(14.0), 12u);
}

TEST(Clock, TimesOfWaypointsMapBackToTheWaypoints) {
  const Clock clock = smallClock();
  for (std::size_t w = 0; w < 12; ++w) {
    const std::optional<double> t = clock.timeOfWaypoint(w);
    ASSERT_TRUE(t);
    EXPECT_EQ(clock.printedWaypoints(*t), w + 1);
  }
  EXPECT_FALSE(clock.timeOfWaypoint(12));
}

TEST(Clock, AWaypointThatWasLeftOutHasNoTime) {
  const test::SampleProgram p = sampleProgram(1, 4);
  p.trajectory->waypoint[2] = plan::kNoWaypoint;
  const Clock clock(p.trajectory, p.toolPlan);
  EXPECT_TRUE(clock.timeOfWaypoint(0));
  EXPECT_FALSE(clock.timeOfWaypoint(1));
  EXPECT_EQ(clock.printedWaypoints(3.0), 3u); // passed over
}

// A wait of 3 s before point 5, in two events, and one of 2 s before point 10.
Clock waitingClock() {
  const test::SampleProgram p = sampleProgram(3, 4);
  for (const auto& [point, seconds] : {std::pair<std::size_t, double>{5, 1.0}, {5, 2.0}, {10, 2.0}})
    p.trajectory->events.push_back(
        {.point = point, .kind = plan::EventKind::Wait, .seconds = seconds});
  return Clock(p.trajectory, p.toolPlan);
}

TEST(Clock, TimesIncludeWaits) {
  const Clock clock = waitingClock();
  EXPECT_DOUBLE_EQ(clock.durationS(), 19.0);
  EXPECT_DOUBLE_EQ(clock.timeOfPoint(4), 4.0);
  EXPECT_DOUBLE_EQ(clock.timeOfPoint(5), 8.0);
  EXPECT_DOUBLE_EQ(clock.timeOfPoint(10), 15.0);
  EXPECT_EQ(clock.pointAt(7.9), 4u);
  EXPECT_EQ(clock.printedWaypoints(7.9), 4u);
  ASSERT_EQ(clock.waits().size(), 2u);
  EXPECT_DOUBLE_EQ(clock.waits()[0].fromS, 4.0);
  EXPECT_DOUBLE_EQ(clock.waits()[0].toS, 7.0);
  EXPECT_DOUBLE_EQ(clock.waits()[1].fromS, 12.0);
  EXPECT_DOUBLE_EQ(clock.waits()[1].toS, 14.0);
}

TEST(Clock, TheArmRestsWhileItWaits) {
  const Clock clock = waitingClock(), without = smallClock();
  for (const double t : {4.0, 4.5, 7.0})
    EXPECT_EQ(clock.jointsAt(t), without.jointsAt(4.0)) << t;
  for (const double share : {0.25, 0.5, 1.0})
    EXPECT_TRUE(clock.jointsAt(7.0 + share).isApprox(without.jointsAt(4.0 + share), 1e-12));
  EXPECT_TRUE(clock.jointsAt(19.0).isApprox(without.jointsAt(14.0), 1e-12));
}

TEST(Clock, ReturnsTheLayerAtATime) {
  const Clock clock = smallClock();
  EXPECT_EQ(clock.layerAt(0.0), 0);
  EXPECT_EQ(clock.layerAt(5.5), 0); // on its way to the next
  EXPECT_EQ(clock.layerAt(6.0), 1);
  EXPECT_EQ(clock.layerAt(100.0), 2);
}

TEST(Clock, StepsByMovesAndLayers) {
  const Clock clock = smallClock();
  EXPECT_DOUBLE_EQ(clock.nextMoveS(2.0), 3.0);
  EXPECT_DOUBLE_EQ(clock.nextMoveS(2.5), 3.0);
  EXPECT_DOUBLE_EQ(clock.previousMoveS(2.5), 2.0);
  EXPECT_DOUBLE_EQ(clock.previousMoveS(2.0), 1.0);
  EXPECT_DOUBLE_EQ(clock.nextMoveS(14.0), 14.0);
  EXPECT_DOUBLE_EQ(clock.previousMoveS(0.0), 0.0);
  EXPECT_DOUBLE_EQ(clock.nextLayerS(0.0), 1.0);
  EXPECT_DOUBLE_EQ(clock.nextLayerS(1.0), 6.0);
  EXPECT_DOUBLE_EQ(clock.nextLayerS(12.0), 14.0);
  EXPECT_DOUBLE_EQ(clock.previousLayerS(14.0), 11.0);
  EXPECT_DOUBLE_EQ(clock.previousLayerS(11.0), 6.0);
  EXPECT_DOUBLE_EQ(clock.previousLayerS(1.0), 0.0);
}

TEST(Clock, RefusesTimesThatRunBackwards) {
  const test::SampleProgram p = sampleProgram(1, 4);
  p.trajectory->timeS[2] = 0.5;
  EXPECT_THROW(Clock(p.trajectory, p.toolPlan), base::Error);
}

} // namespace
} // namespace voluta::timeline
