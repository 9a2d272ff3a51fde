#include "together/schedule.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace voluta::together {

bool isFree(const Conflicts& c, const Phase& p) {
  if (p.aFrom == p.aTo || p.bFrom == p.bTo) {
    for (std::size_t n = p.bFrom; n < p.bTo; ++n)
      if (c.aRests.at(p.aFrom, n))
        return false;
    for (std::size_t m = p.aFrom; m < p.aTo; ++m)
      if (c.bRests.at(m, p.bFrom))
        return false;
    return true;
  }
  for (std::size_t m = p.aFrom; m < p.aTo; ++m)
    for (std::size_t n = p.bFrom; n < p.bTo; ++n)
      if (c.moving.at(m, n))
        return false;
  return true;
}

namespace {
constexpr double kNone = std::numeric_limits<double>::infinity();

class Search {
public:
  Search(const Conflicts& conflicts, std::span<const double> aS, std::span<const double> bS,
         double markS)
      : c_(conflicts), a_(sums(aS)), b_(sums(bS)), markS_(markS), states_((c_.a + 1) * (c_.b + 1)) {
    const double count = static_cast<double>(states_.size());
    window_ = static_cast<std::size_t>(std::max(8.0, std::sqrt(kExactSteps / count)));
  }

  std::optional<Schedule> run() {
    at(0, 0).cost = 0.0;
    for (std::size_t i = 0; i <= c_.a; ++i)
      for (std::size_t j = 0; j <= c_.b; ++j)
        if (at(i, j).cost < kNone)
          extend(i, j);
    if (at(c_.a, c_.b).cost == kNone)
      return std::nullopt;
    return joined(path());
  }

  std::pair<std::size_t, std::size_t> furthest() const {
    std::pair<std::size_t, std::size_t> best{0, 0};
    for (std::size_t i = 0; i <= c_.a; ++i)
      for (std::size_t j = 0; j <= c_.b; ++j)
        if (states_[i * (c_.b + 1) + j].cost < kNone && i + j >= best.first + best.second)
          best = {i, j};
    return best;
  }

private:
  struct State {
    double cost = kNone;
    std::uint32_t fromA = 0, fromB = 0;
  };
  State& at(std::size_t i, std::size_t j) { return states_[i * (c_.b + 1) + j]; }

  static std::vector<double> sums(std::span<const double> seconds) {
    std::vector<double> sum = {0.0};
    for (const double s : seconds)
      sum.push_back(sum.back() + s);
    return sum;
  }
  double secondsOf(const Phase& p) const {
    return std::max(a_[p.aTo] - a_[p.aFrom], b_[p.bTo] - b_[p.bFrom]);
  }

  void reach(const Phase& p) {
    State& to = at(p.aTo, p.bTo);
    const double cost = at(p.aFrom, p.bFrom).cost + secondsOf(p) + markS_;
    if (cost < to.cost)
      to = {cost, static_cast<std::uint32_t>(p.aFrom), static_cast<std::uint32_t>(p.bFrom)};
  }

  void extend(std::size_t i, std::size_t j) {
    const std::size_t aEnd = std::min(c_.a, i + window_), bEnd = std::min(c_.b, j + window_);
    for (std::size_t n = j; n < bEnd && !c_.aRests.at(i, n); ++n)
      reach({i, i, j, n + 1});
    for (std::size_t m = i; m < aEnd && !c_.bRests.at(m, j); ++m)
      reach({i, m + 1, j, j});
    std::size_t limit = bEnd;
    for (std::size_t m = i; m < aEnd && limit > j; ++m) {
      for (std::size_t n = j; n < limit; ++n)
        if (c_.moving.at(m, n))
          limit = n;
      for (std::size_t n = j; n < limit; ++n)
        reach({i, m + 1, j, n + 1});
    }
  }

  std::vector<Phase> path() {
    std::vector<Phase> phases;
    for (std::size_t i = c_.a, j = c_.b; i > 0 || j > 0;) {
      const State& s = at(i, j);
      phases.push_back({s.fromA, i, s.fromB, j});
      i = s.fromA;
      j = s.fromB;
    }
    std::ranges::reverse(phases);
    return phases;
  }

  // A window can end a phase early.
  Schedule joined(const std::vector<Phase>& phases) const {
    Schedule schedule;
    for (const Phase& p : phases) {
      if (!schedule.phases.empty()) {
        const Phase& last = schedule.phases.back();
        const Phase both{last.aFrom, p.aTo, last.bFrom, p.bTo};
        if (isFree(c_, both)) {
          schedule.phases.back() = both;
          continue;
        }
      }
      schedule.phases.push_back(p);
    }
    for (const Phase& p : schedule.phases)
      schedule.seconds += secondsOf(p);
    return schedule;
  }

  const Conflicts& c_;
  const std::vector<double> a_, b_; // time until each rest
  double markS_;
  std::size_t window_ = 0;
  std::vector<State> states_;
};
} // namespace

std::optional<Schedule> fastestSchedule(const Conflicts& conflicts, std::span<const double> aS,
                                        std::span<const double> bS, double markS) {
  base::require(aS.size() == conflicts.a && bS.size() == conflicts.b, "a time per segment");
  return Search(conflicts, aS, bS, markS).run();
}

std::pair<std::size_t, std::size_t> furthestReached(const Conflicts& conflicts) {
  const std::vector<double> aS(conflicts.a, 1.0), bS(conflicts.b, 1.0);
  Search search(conflicts, aS, bS, 0.0);
  search.run();
  return search.furthest();
}

} // namespace voluta::together
