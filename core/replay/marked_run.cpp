#include "replay/marked_run.h"

#include "base/error.h"
#include "plan/marks.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace voluta::replay {

std::vector<MarkedAction> markedActions(const plan::ReadProgram& program,
                                        const std::vector<double>& motionS) {
  using Kind = MarkedAction::Kind;
  std::vector<MarkedAction> actions;
  std::size_t pause = 0, fact = 0;
  const auto pausesBelow = [&](std::size_t end) {
    for (; pause < end; ++pause)
      actions.push_back({Kind::Pause, program.pauses[pause].durationS});
  };
  for (std::size_t m = 0; m <= motionS.size(); ++m) {
    for (; fact < program.facts.size() && program.facts[fact].before <= m; ++fact) {
      const plan::StatedFact& f = program.facts[fact];
      const bool isSet = f.kind == plan::FactKind::MarkSet;
      if (!isSet && f.kind != plan::FactKind::MarkAwaited)
        continue;
      pausesBelow(std::min(f.beforePause, program.pauses.size()));
      const int code = static_cast<int>(f.number);
      actions.push_back({isSet ? Kind::Set : Kind::Await, 0.0, plan::markSignalOf(code),
                         plan::markIsOn(code), f.file, f.line});
    }
    std::size_t end = pause;
    while (end < program.pauses.size() && program.pauses[end].before <= m)
      ++end;
    pausesBelow(end);
    if (m < motionS.size())
      actions.push_back({Kind::Move, motionS[m]});
  }
  return actions;
}

std::vector<MarkedAction> joinedMotions(const std::vector<MarkedAction>& actions) {
  using Kind = MarkedAction::Kind;
  std::vector<MarkedAction> joined;
  for (const MarkedAction& action : actions) {
    const bool takesTime = action.kind == Kind::Move || action.kind == Kind::Pause;
    if (takesTime && !joined.empty() && joined.back().kind == Kind::Move) {
      joined.back().seconds += action.seconds;
    } else {
      joined.push_back(action);
      if (takesTime)
        joined.back().kind = Kind::Move;
    }
  }
  return joined;
}

namespace {

// An output over time.
struct Signal {
  bool atFirst = false;
  std::vector<std::pair<double, bool>> changes;

  // Returns the first time from `fromS` on at which it has this value, as far as it is known.
  std::optional<double> when(bool on, double fromS) const {
    bool value = atFirst;
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
  Machine(std::size_t own, const std::vector<MarkedAction>& actions, const Start& start,
          MachineClock& clock)
      : own_(own), actions_(actions), clock_(clock), now_(start.delayS.at(own)) {
    for (std::size_t s = 0; s < signals_.size(); ++s)
      signals_[s].atFirst = start.on.at(own).test(s);
  }

  double now() const { return now_; }
  bool ended() const { return next_ == actions_.size(); }
  const MarkedAction& next() const { return actions_[next_]; }

  // Does the next action. Returns false if it waits for a signal that is not given yet.
  // Precondition: it has not ended.
  bool step(const std::vector<Machine>& all) {
    const MarkedAction& action = actions_[next_];
    switch (action.kind) {
    case MarkedAction::Kind::Move:
      clock_.beginS.push_back(now_);
      pass(action.seconds);
      clock_.endS.push_back(now_);
      break;
    case MarkedAction::Kind::Pause:
      pass(action.seconds);
      break;
    case MarkedAction::Kind::Set:
      signals_.at(static_cast<std::size_t>(action.signal)).changes.emplace_back(now_, action.on);
      break;
    case MarkedAction::Kind::Await: {
      const std::size_t peer = plan::markPeer(own_, action.signal / 2);
      const auto when =
          peer < all.size() ? all[peer].shows(own_, action, now_) : std::optional<double>();
      arrive(peer, action);
      if (!when)
        return false;
      now_ = *when + kSignalS;
      clock_.marks.back().toS = now_;
      break;
    }
    }
    ++next_;
    clock_.totalS = now_;
    return true;
  }

private:
  void pass(double seconds) {
    now_ += seconds;
    isAtMark_ = false;
  }

  // Each mark awaits the first signal of a channel once until it is on.
  void arrive(std::size_t peer, const MarkedAction& action) {
    const bool announces = action.signal % 2 == 0 && action.on;
    const bool waitsAlready = awaited_ == next_;
    if (!isAtMark_ || clock_.marks.back().other != peer ||
        (announces && isAnnounced_ && !waitsAlready)) {
      clock_.marks.push_back({peer, now_, now_, action.file, action.line});
      isAnnounced_ = false;
    }
    isAtMark_ = true;
    isAnnounced_ = isAnnounced_ || announces;
    awaited_ = next_;
  }

  // Returns when the machine shows another one the value that it waits for.
  std::optional<double> shows(std::size_t to, const MarkedAction& action, double fromS) const {
    const int signal = 2 * plan::markChannel(own_, to) + action.signal % 2;
    return signals_.at(static_cast<std::size_t>(signal)).when(action.on, fromS);
  }

  std::size_t own_;
  const std::vector<MarkedAction>& actions_;
  MachineClock& clock_;
  std::size_t next_ = 0;
  double now_ = 0.0;
  bool isAtMark_ = false, isAnnounced_ = false; // at the last mark of the clock
  std::optional<std::size_t> awaited_;          // action that waited last
  std::array<Signal, plan::kMarkSignals> signals_;
};

} // namespace

CommonClock runMarked(std::span<const std::vector<MarkedAction>> programs, const Start& start) {
  base::require(programs.size() > 1 && programs.size() <= plan::kMaxMachines,
                "runMarked: two to four machines");
  CommonClock clock;
  clock.machines.resize(programs.size());
  std::vector<Machine> machines;
  for (std::size_t k = 0; k < programs.size(); ++k)
    machines.emplace_back(k, programs[k], start, clock.machines[k]);
  std::vector<std::size_t> running;
  for (;;) {
    // The one that is behind goes on first, so that the signals of the others are known by then.
    running.clear();
    for (std::size_t k = 0; k < machines.size(); ++k)
      if (!machines[k].ended())
        running.push_back(k);
    if (running.empty())
      return clock;
    std::ranges::stable_sort(running, {}, [&](std::size_t k) { return machines[k].now(); });
    if (std::ranges::any_of(running, [&](std::size_t k) { return machines[k].step(machines); }))
      continue;
    const MarkedAction& waits = machines[running.front()].next();
    clock.stuck = Stuck{running.front(), waits.file, waits.line};
    return clock;
  }
}

} // namespace voluta::replay
