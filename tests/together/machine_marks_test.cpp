// Marks in the motions of both machines.
#include "plan/marks.h"
#include "together/machine_marks.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace voluta::together {
namespace {

TEST(Marks, CodesAndLinksHaveInverses) {
  for (int signal = 0; signal < plan::kMarkSignals; ++signal)
    for (const bool on : {false, true}) {
      EXPECT_EQ(plan::markSignalOf(plan::markCode(signal, on)), signal);
      EXPECT_EQ(plan::markIsOn(plan::markCode(signal, on)), on);
    }
  for (int channel = 0; channel < plan::kMarkChannels; ++channel)
    for (const bool leads : {false, true}) {
      const int link = plan::markLink(channel, leads);
      EXPECT_LT(link, plan::kMarkLinks);
      EXPECT_EQ(plan::markChannelOf(link), channel);
      EXPECT_EQ(plan::markLeads(link), leads);
    }
  EXPECT_TRUE(plan::markLeads(plan::markLinkOf(0, 1)));
  EXPECT_FALSE(plan::markLeads(plan::markLinkOf(1, 0)));
}

TEST(Marks, EachOfTheOthersHasAChannel) {
  for (std::size_t own = 0; own < plan::kMaxMachines; ++own)
    for (std::size_t other = 0; other < plan::kMaxMachines; ++other)
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
  constexpr int kFollows = plan::kMarkChannels;
  // Behind a start mark with each of the others.
  EXPECT_EQ(marksOf(order, 0, a), (Places{{0, 0}, {0, 1}, {20, 0}, {20, 1}}));
  EXPECT_EQ(marksOf(order, 1, b), (Places{{0, kFollows}, {0, 1}, {5, kFollows}, {40, 1}}));
  EXPECT_EQ(marksOf(order, 2, c),
            (Places{{0, kFollows}, {0, 1 + kFollows}, {0, kFollows}, {7, 1 + kFollows}}));
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

// ---- every interleaving of two machines

// The statements of one end: start mark and two more marks.
struct End {
  enum class Kind { Set, Await, Arrive, Pass, AtStart, Settle };
  struct Step {
    Kind kind;
    int value = 0; // signal; mark
    bool on = false;
  };
  std::vector<Step> steps;
  int atStart = 0, started = 0; // steps: the machine is at its first point; passes the start mark

  explicit End(bool leads) {
    steps.push_back({Kind::Set, 0, false});
    steps.push_back({Kind::Settle}); // the motion to the first point
    atStart = static_cast<int>(steps.size());
    steps.push_back({Kind::AtStart});
    for (int mark = 0; mark < 3; ++mark) {
      if (mark > 0)
        steps.push_back({Kind::Arrive, mark});
      for (const plan::MarkStep& step : plan::markSteps(leads, mark == 0))
        steps.push_back({step.sets ? Kind::Set : Kind::Await, step.signal, step.on});
      if (mark == 0)
        started = static_cast<int>(steps.size());
      steps.push_back({Kind::Pass, mark});
    }
    for (int signal = 0; signal < 2; ++signal)
      steps.push_back({Kind::Set, signal, false});
  }
  int size() const { return static_cast<int>(steps.size()); }
};

// Of both machines. Bits of signals: as set, and as the other one sees them.
struct State {
  std::array<int, 2> at{-1, -1}; // step; -1: not started
  std::array<unsigned, 2> set{}, seen{};
  std::array<int, 2> may{-1, -1}; // last mark that the other allows to pass
  bool isJoined = false;          // one passed the start mark, and the other one may
  // The other one was stopped when it had passed the start mark that this one has not passed yet.
  std::array<bool, 2> isLeft{};
  friend auto operator<=>(const State&, const State&) = default;
};

class Explorer {
public:
  Explorer() : ends_{End(true), End(false)} {
    for (unsigned signals = 0; signals < 16; ++signals) {
      State state;
      state.set = state.seen = {signals & 3U, signals >> 2};
      add(state);
    }
    while (!todo_.empty()) {
      const State state = todo_.back();
      todo_.pop_back();
      explore(state);
    }
  }
  std::size_t states() const { return found_.size(); }
  std::size_t early = 0, stuck = 0, ended = 0;

private:
  void add(const State& state) {
    if (found_.insert(state).second)
      todo_.push_back(state);
  }
  bool isAtStart(const State& state, std::size_t k) const {
    return state.at[k] > ends_[k].atStart && state.at[k] <= ends_[k].started;
  }

  void explore(const State& state) {
    bool continues = false;
    for (std::size_t k = 0; k < 2; ++k) {
      continues = restart(state, k) || continues;
      for (unsigned bit = 1; bit < 4; bit *= 2)
        if (((state.set[k] ^ state.seen[k]) & bit) != 0) {
          State next = state;
          next.seen[k] ^= bit;
          add(next);
          continues = true;
        }
      continues = step(state, k) || continues;
    }
    const bool bothEnded = state.at[0] == ends_[0].size() && state.at[1] == ends_[1].size();
    ended += bothEnded ? 1 : 0;
    if (continues || bothEnded || state.at[0] < 0 || state.at[1] < 0)
      return;
    // A machine within its old program waits until it is stopped.
    bool isOld = state.isLeft[0] || state.isLeft[1];
    for (std::size_t k = 0; k < 2; ++k)
      isOld = isOld || (!state.isJoined && state.at[k] > ends_[k].started);
    stuck += isOld ? 0 : 1;
  }

  // Starts a machine, or stops and restarts it, at any moment except during both start marks.
  // Returns whether it was not started before.
  bool restart(const State& state, std::size_t k) {
    const std::size_t other = 1 - k;
    if (state.at[k] == 0 || (isAtStart(state, k) && isAtStart(state, other)) ||
        state.set != state.seen)
      return false;
    State next = state;
    next.at[k] = 0;
    next.may[k] = -1;
    next.isLeft[k] = false;
    next.isLeft[other] = state.isLeft[other] || (state.isJoined && isAtStart(state, other));
    next.isJoined = false;
    add(next);
    return state.at[k] < 0;
  }

  bool step(const State& state, std::size_t k) {
    if (state.at[k] < 0 || state.at[k] == ends_[k].size())
      return false;
    const std::size_t other = 1 - k;
    const End::Step& step = ends_[k].steps[static_cast<std::size_t>(state.at[k])];
    State next = state;
    ++next.at[k];
    switch (step.kind) {
    case End::Kind::Set:
      next.set[k] = step.on ? next.set[k] | 1U << step.value : next.set[k] & ~(1U << step.value);
      break;
    case End::Kind::Await:
      if ((state.seen[other] >> step.value & 1U) != (step.on ? 1U : 0U))
        return false;
      break;
    case End::Kind::Settle:
      if (state.set[k] != state.seen[k])
        return false;
      break;
    case End::Kind::AtStart:
      if (isAtStart(state, other))
        next.may = {0, 0};
      break;
    case End::Kind::Arrive:
      if (state.isJoined)
        next.may[other] = std::max(next.may[other], step.value);
      break;
    case End::Kind::Pass:
      if (state.may[k] < step.value) {
        ++early;
        return true;
      }
      next.isJoined = state.isJoined || step.value == 0;
      break;
    }
    add(next);
    return true;
  }

  std::array<End, 2> ends_;
  std::set<State> found_;
  std::vector<State> todo_;
};

// For any initial signals, any delay of each of them, and any time at which either machine is
// stopped and restarted.
TEST(Marks, AreNeverPassedEarlyAndNeverWaitForEver) {
  const Explorer all;
  EXPECT_EQ(all.early, 0u);
  EXPECT_EQ(all.stuck, 0u);
  EXPECT_GT(all.ended, 0u);
  EXPECT_GT(all.states(), 1000u);
}

} // namespace
} // namespace voluta::together
