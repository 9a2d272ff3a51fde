#include "base/error.h"
#include "plan/marks.h"
#include "replay/shared_run.h"

#include <algorithm>
#include <array>
#include <numeric>
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
  Machine(std::size_t own, std::vector<Action> actions, MachineClock& clock)
      : own_(own), actions_(std::move(actions)), clock_(clock) {}

  double now() const { return now_; }
  bool ended() const { return next_ == actions_.size(); }
  const Action& next() const { return actions_[next_]; }

  // Does the next action. Returns false if it waits for a signal that is not given yet.
  // Precondition: it has not ended.
  bool step(const std::vector<Machine>& all) {
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
      signals_.at(static_cast<std::size_t>(plan::markSignal(action.place)))
          .changes.emplace_back(now_, plan::markIsOn(action.place));
      break;
    case Action::Kind::Await: {
      const std::size_t peer = plan::markPeer(own_, plan::markChannelOf(action.place));
      const auto when =
          peer < all.size() ? all[peer].shows(own_, action.place, now_) : std::optional<double>();
      if (!when)
        return false;
      clock_.marks.push_back({peer, now_, *when + kSignalS});
      now_ = *when + kSignalS;
      break;
    }
    }
    ++next_;
    clock_.totalS = now_;
    return true;
  }

private:
  // Returns when the machine shows another one the signal of a place of that one's channel.
  std::optional<double> shows(std::size_t to, int place, double fromS) const {
    const int signal = 2 * plan::markChannel(own_, to) + plan::markSignal(place) % 2;
    return signals_.at(static_cast<std::size_t>(signal)).when(plan::markIsOn(place), fromS);
  }

  std::size_t own_;
  std::vector<Action> actions_;
  MachineClock& clock_;
  std::size_t next_ = 0;
  double now_ = 0.0;
  std::array<Signal, plan::kMarkSignals> signals_;
};

} // namespace

double MachineClock::waitS() const {
  return std::accumulate(marks.begin(), marks.end(), 0.0, [](double sum, const PassedMark& mark) {
    return sum + mark.toS - mark.fromS;
  });
}

CommonClock commonClock(std::span<const plan::ReadProgram* const> programs,
                        std::span<const std::vector<double>> motionS) {
  base::require(programs.size() > 1 && programs.size() <= plan::kMostMachines &&
                    motionS.size() == programs.size(),
                "commonClock: machines with times");
  CommonClock clock;
  clock.machines.resize(programs.size());
  std::vector<Machine> machines;
  for (std::size_t k = 0; k < programs.size(); ++k)
    machines.emplace_back(k, actionsOf(*programs[k], motionS[k]), clock.machines[k]);
  for (;;) {
    // The one that is behind goes on first, so that the signals of the others are known by then.
    std::vector<std::size_t> running;
    for (std::size_t k = 0; k < machines.size(); ++k)
      if (!machines[k].ended())
        running.push_back(k);
    if (running.empty())
      return clock;
    std::ranges::stable_sort(running, {}, [&](std::size_t k) { return machines[k].now(); });
    if (std::ranges::any_of(running, [&](std::size_t k) { return machines[k].step(machines); }))
      continue;
    const Action& waits = machines[running.front()].next();
    clock.stuck = Stuck{running.front(), waits.file, waits.line};
    return clock;
  }
}

} // namespace voluta::replay
