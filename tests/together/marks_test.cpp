// Marks in the motions of both machines.
#include "plan/marks.h"
#include "together/marks.h"

#include <gtest/gtest.h>

namespace voluta::together {
namespace {

TEST(Marks, TheCycleOfAChannelUsesBothSignalsInTurn) {
  for (int channel = 0; channel < plan::kMarkChannels; ++channel)
    for (std::size_t number = 1; number <= 20; ++number) {
      const int place = plan::markPlace(channel, number);
      EXPECT_EQ(plan::markChannelOf(place), channel);
      EXPECT_EQ(plan::markSignal(place) / 2, channel);
      EXPECT_EQ(plan::markPlaceOf(plan::markSignal(place), plan::markIsOn(place)), place);
      // A signal stays until the mark after the next one.
      const int next = plan::markPlace(channel, number + 1),
                afterNext = plan::markPlace(channel, number + 2);
      EXPECT_NE(plan::markSignal(next), plan::markSignal(place));
      EXPECT_EQ(plan::markSignal(afterNext), plan::markSignal(place));
      EXPECT_NE(plan::markIsOn(afterNext), plan::markIsOn(place));
    }
}

TEST(Marks, EachOfTheOthersHasAChannel) {
  for (std::size_t own = 0; own < plan::kMostMachines; ++own)
    for (std::size_t other = 0; other < plan::kMostMachines; ++other)
      if (own != other) {
        const int channel = plan::markChannel(own, other);
        EXPECT_GE(channel, 0);
        EXPECT_LT(channel, plan::kMarkChannels);
        EXPECT_EQ(plan::markPeer(own, channel), other);
      }
}

TEST(Marks, AreAtTheRestsOfTheRendezvous) {
  const Order order{{{0, 1, 2, 1}, {0, 2, 2, 0}, {1, 2, 3, 1}}, 0.0, {}};
  const Rests a{{0, 10, 20, 30}, {}}, b{{0, 5, 6, 40}, {}}, c{{0, 7}, {}};
  using Places = std::vector<MarkPlace>;
  EXPECT_EQ(marksOf(order, 0, a), (Places{{20, 0}, {20, 1}}));
  EXPECT_EQ(marksOf(order, 1, b), (Places{{5, 0}, {40, 1}}));
  EXPECT_EQ(marksOf(order, 2, c), (Places{{0, 0}, {7, 1}}));
}

TEST(Marks, ComeBeforeOtherEventsAndKeepTheRest) {
  plan::Trajectory t;
  t.dof = 1;
  for (int i = 0; i < 6; ++i) {
    t.joints.push_back(i);
    t.timeS.push_back(i);
    t.move.push_back(plan::MoveKind::Joint);
    t.waypoint.push_back(plan::kNoWaypoint);
    t.extrudedMm3.push_back(0.0);
  }
  t.events = {{.point = 2, .kind = plan::EventKind::Pause},
              {.point = 3, .kind = plan::EventKind::Wait, .seconds = 4.0}};
  const plan::Trajectory marked = withMarks(t, {{2, 0}, {2, 1}, {5, 0}});
  ASSERT_EQ(marked.events.size(), 5u);
  EXPECT_EQ(marked.events[0].kind, plan::EventKind::Pause);
  EXPECT_EQ(marked.events[1].kind, plan::EventKind::Mark);
  EXPECT_EQ(marked.events[2].kind, plan::EventKind::Mark);
  EXPECT_EQ(marked.events[1].tool, 0);
  EXPECT_EQ(marked.events[2].tool, 1);
  EXPECT_EQ(marked.events[3].kind, plan::EventKind::Wait);
  EXPECT_EQ(marked.events[4].kind, plan::EventKind::Mark);
  EXPECT_EQ(marked.events[4].point, 6u) << "at the end";
  EXPECT_EQ(marked.joints, t.joints);
}

} // namespace
} // namespace voluta::together
