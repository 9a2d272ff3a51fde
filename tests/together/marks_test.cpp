// Marks in the motions of both machines.
#include "plan/marks.h"
#include "together/marks.h"

#include <gtest/gtest.h>

namespace voluta::together {
namespace {

TEST(Marks, TheCycleUsesBothSignalsInTurn) {
  for (std::size_t number = 1; number <= 20; ++number) {
    const int place = plan::markPlace(number);
    EXPECT_EQ(plan::markPlaceOf(plan::markSignal(place), plan::markIsOn(place)), place);
    // A signal stays until the mark after the next one.
    const int next = plan::markPlace(number + 1), afterNext = plan::markPlace(number + 2);
    EXPECT_NE(plan::markSignal(next), plan::markSignal(place));
    EXPECT_EQ(plan::markSignal(afterNext), plan::markSignal(place));
    EXPECT_NE(plan::markIsOn(afterNext), plan::markIsOn(place));
  }
}

TEST(Marks, AreAtTheRestsWherePhasesBegin) {
  const Schedule schedule{{{0, 2, 0, 1}, {2, 2, 1, 3}, {2, 3, 3, 3}}, 0.0};
  const Rests a{{0, 10, 20, 30}, {}}, b{{0, 5, 6, 40}, {}};
  EXPECT_EQ(marksOfA(schedule, a), (std::vector<std::size_t>{20, 20}));
  EXPECT_EQ(marksOfB(schedule, b), (std::vector<std::size_t>{5, 40}));
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
  const plan::Trajectory marked = withMarks(t, {2, 2, 5});
  ASSERT_EQ(marked.events.size(), 5u);
  EXPECT_EQ(marked.events[0].kind, plan::EventKind::Pause);
  EXPECT_EQ(marked.events[1].kind, plan::EventKind::Mark);
  EXPECT_EQ(marked.events[2].kind, plan::EventKind::Mark);
  EXPECT_EQ(marked.events[3].kind, plan::EventKind::Wait);
  EXPECT_EQ(marked.events[4].kind, plan::EventKind::Mark);
  EXPECT_EQ(marked.events[4].point, 6u) << "at the end";
  EXPECT_EQ(marked.joints, t.joints);
}

} // namespace
} // namespace voluta::together
