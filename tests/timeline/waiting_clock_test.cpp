// A machine's own time within a common time in which it waits.
#include "timeline/waiting_clock.h"

#include <gtest/gtest.h>

namespace voluta::timeline {
namespace {

TEST(WaitingClocks, StopDuringAWait) {
  // Runs 10 s, waits 5 s, runs its further 20 s in 40 s: the controller is slower than planned.
  const WaitingClock clock({{10.0, 10.0, 15.0}}, 30.0, 55.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(4.0), 4.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(10.0), 10.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(13.0), 10.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(15.0), 10.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(35.0), 20.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(55.0), 30.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(99.0), 30.0);
}

TEST(WaitingClocks, SeveralWaitsMayFollowAtOnePlace) {
  const WaitingClock clock({{0.0, 0.0, 2.0}, {0.0, 2.0, 3.0}, {5.0, 8.0, 8.0}}, 6.0, 9.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(1.0), 0.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(2.5), 0.0);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(5.5), 2.5);
  EXPECT_DOUBLE_EQ(clock.ownTimeS(8.5), 5.5);
  double before = 0.0;
  for (int k = 0; k <= 100; ++k) {
    const double own = clock.ownTimeS(0.1 * k);
    EXPECT_GE(own, before);
    before = own;
  }
}

TEST(WaitingClocks, WithoutAMotionHaveNoTime) {
  EXPECT_DOUBLE_EQ(WaitingClock().ownTimeS(5.0), 0.0);
}

} // namespace
} // namespace voluta::timeline
