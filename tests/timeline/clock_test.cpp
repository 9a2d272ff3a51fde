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

TEST(Clock, CountsWhatIsPrinted) {
  const Clock clock = smallClock();
  EXPECT_EQ(clock.printedWaypoints(0.5), 0u);
  EXPECT_EQ(clock.printedWaypoints(1.0), 1u);
  EXPECT_EQ(clock.printedWaypoints(4.9), 4u);
  EXPECT_EQ(clock.printedWaypoints(5.5), 4u); // travelling
  EXPECT_EQ(clock.printedWaypoints(6.0), 5u);
  EXPECT_EQ(clock.printedWaypoints(14.0), 12u);
}

TEST(Clock, WaypointsAndTheirTimesGoBothWays) {
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

TEST(Clock, KnowsTheLayer) {
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
