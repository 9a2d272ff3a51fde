#include "plan/marks.h"
#include "replay/two_machines.h"

#include <algorithm>
#include <utility>

namespace voluta::replay {

namespace {

// A step of a program that takes time or concerns marks.
struct Action {
  enum class Kind { Move, Pause, Set, Await };
  Kind kind = Kind::Move;
  double seconds = 0.0;
  int place = 0;                  // of a mark (plan/marks.h)
  std::size_t file = 0, line = 0; // of a mark
};

std::vector<Action> actionsOf(const plan::ReadProgram& program,
                              const std::vector<double>& motionS) {
  std::vector<Action> actions;
  std::size_t pause = 0, fact = 0;
  const auto pausesBelow = [&](std::size_t end) {
    for (; pause < end; ++pause)
      actions.push_back({Action::Kind::Pause, program.pauses[pause].durationS});
  };
  for (std::size_t m = 0; m <= motionS.size(); ++m) {
    for (; fact < program.facts.size() && program.facts[fact].before <= m; ++fact) {
      const plan::StatedFact& f = program.facts[fact];
      const bool isSet = f.kind == plan::FactKind::MarkSet;
      if (!isSet && f.kind != plan::FactKind::MarkAwaited)
        continue;
      pausesBelow(std::min(f.beforePause, program.pauses.size()));
      actions.push_back({isSet ? Action::Kind::Set : Action::Kind::Await, 0.0,
                         static_cast<int>(f.number), f.file, f.line});
    }
    std::size_t end = pause;
    while (end < program.pauses.size() && program.pauses[end].before <= m)
      ++end;
    pausesBelow(end);
    if (m < motionS.size())
      actions.push_back({Action::Kind::Move, motionS[m]});
  }
  return actions;
}

// An output over time; off at first.
struct Signal {
  std::vector<std::pair<double, bool>> changes;

  // Returns the first time from `fromS` on at which it has this value, as far as it is known.
  std::optional<double> when(bool on, double fromS) const {
    bool value = false;
    for (std::size_t k = 0; k <= changes.size(); ++k) {
      const double endS = k < changes.size() ? changes[k].first : fromS + 1.0;
      const bool lasts = k == changes.size() || endS > fromS;
      if (value == on && lasts)
        return std::max(fromS, k > 0 ? changes[k - 1].first : 0.0);
      if (k < changes.size())
        value = changes[k].second;
    }
    return std::nullopt;
  }
};

class Machine {
public:
  Machine(std::vector<Action> actions, MachineClock& clock)
      : actions_(std::move(actions)), clock_(clock) {}

  double now() const { return now_; }
  bool ended() const { return next_ == actions_.size(); }
  const Action& next() const { return actions_[next_]; }

  // Does the next action. Returns false if it waits for a signal that the other has not given yet.
  bool step(const Machine& other) {
    const Action& action = actions_[next_];
    switch (action.kind) {
    case Action::Kind::Move:
      clock_.beginS.push_back(now_);
      now_ += action.seconds;
      clock_.endS.push_back(now_);
      break;
    case Action::Kind::Pause:
      now_ += action.seconds;
      break;
    case Action::Kind::Set:
      signals_[static_cast<std::size_t>(plan::markSignal(action.place))].changes.emplace_back(
          now_, plan::markIsOn(action.place));
      break;
    case Action::Kind::Await: {
      const Signal& signal =
          other.signals_[static_cast<std::size_t>(plan::markSignal(action.place))];
      const auto when = signal.when(plan::markIsOn(action.place), now_);
      if (!when)
        return false;
      clock_.waitS += *when + kSignalS - now_;
      now_ = *when + kSignalS;
      ++clock_.marks;
      break;
    }
    }
    ++next_;
    clock_.totalS = now_;
    return true;
  }

private:
  std::vector<Action> actions_;
  MachineClock& clock_;
  std::size_t next_ = 0;
  double now_ = 0.0;
  std::array<Signal, 2> signals_;
};

} // namespace

CommonClock commonClock(const std::array<const plan::ReadProgram*, 2>& programs,
                        const std::array<std::vector<double>, 2>& motionS) {
  CommonClock clock;
  std::array<Machine, 2> machines{Machine(actionsOf(*programs[0], motionS[0]), clock.machines[0]),
                                  Machine(actionsOf(*programs[1], motionS[1]), clock.machines[1])};
  for (;;) {
    // The one that is behind goes on, so that the signals of the other are known by then.
    std::size_t behind = machines[0].now() <= machines[1].now() ? 0 : 1;
    if (machines[behind].ended())
      behind = 1 - behind;
    if (machines[behind].ended())
      return clock;
    if (machines[behind].step(machines[1 - behind]))
      continue;
    const std::size_t ahead = 1 - behind;
    if (!machines[ahead].ended() && machines[ahead].step(machines[behind]))
      continue;
    clock.stuck = Stuck{behind, machines[behind].next().file, machines[behind].next().line};
    return clock;
  }
}

} // namespace voluta::replay
