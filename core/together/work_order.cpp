#include "together/work_order.h"

#include "base/error.h"
#include "base/run_context.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace voluta::together {

PairConflicts::PairConflicts(std::vector<std::size_t> segments) : segments_(std::move(segments)) {
  base::require(segments_.size() > 1 &&
                    std::ranges::find(segments_, std::size_t{0}) == segments_.end(),
                "PairConflicts: machines with segments");
  for (std::size_t j = 1; j < segments_.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const std::size_t a = segments_[i], b = segments_[j];
      tables_.push_back({a, b, Flags(a, b), Flags(a + 1, b), Flags(a, b + 1)});
    }
}

std::size_t PairConflicts::indexOf(std::size_t lower, std::size_t upper) const {
  return upper * (upper - 1) / 2 + lower;
}
const Conflicts& PairConflicts::of(std::size_t lower, std::size_t upper) const {
  return tables_[indexOf(lower, upper)];
}
Conflicts& PairConflicts::of(std::size_t lower, std::size_t upper) {
  return tables_[indexOf(lower, upper)];
}

bool PairConflicts::meet(std::size_t machine, std::size_t segment, std::size_t other,
                         std::size_t otherSegment) const {
  return machine < other ? of(machine, other).moving.at(segment, otherSegment)
                         : of(other, machine).moving.at(otherSegment, segment);
}
bool PairConflicts::hinders(std::size_t machine, std::size_t rest, std::size_t other,
                            std::size_t otherSegment) const {
  return machine < other ? of(machine, other).aRests.at(rest, otherSegment)
                         : of(other, machine).bRests.at(otherSegment, rest);
}

namespace {
constexpr std::size_t kAbsent = std::numeric_limits<std::size_t>::max();

// Per machine: the rest at which it waits for all others that take part; kAbsent: it takes no part.
using Barrier = std::vector<std::size_t>;

// The moment at which one machine reaches a rest; `rest` of all machines.
struct Cut {
  double timeS = 0.0;
  std::vector<std::size_t> rest;
  std::size_t machine = 0; // that has moved since the cut before
};

std::vector<std::vector<double>> sumsOf(const std::vector<std::vector<double>>& seconds) {
  std::vector<std::vector<double>> sums;
  for (const std::vector<double>& own : seconds) {
    std::vector<double>& sum = sums.emplace_back(1, 0.0);
    for (const double s : own)
      sum.push_back(sum.back() + s);
  }
  return sums;
}

class Insertion {
public:
  Insertion(const PairConflicts& conflicts, const std::vector<std::vector<double>>& sums,
            double markS)
      : conflicts_(conflicts), sums_(sums), markS_(markS) {}

  // Returns false if the machine cannot work beside those inserted before.
  bool insert(std::size_t machine) {
    if (included_.empty()) {
      included_.push_back(machine);
      return true;
    }
    const std::vector<Cut> cuts = this->cuts();
    std::vector<double> seconds, own;
    for (std::size_t s = 0; s + 1 < cuts.size(); ++s)
      seconds.push_back(cuts[s + 1].timeS - cuts[s].timeS);
    for (std::size_t j = 0; j < conflicts_.segments(machine); ++j)
      own.push_back(sums_[machine][j + 1] - sums_[machine][j]);
    const auto schedule = fastestSchedule(against(machine, cuts), seconds, own, markS_);
    if (!schedule)
      return false;
    addBarriers(machine, cuts, *schedule);
    included_.push_back(machine);
    return true;
  }

  Order order() const {
    Order order;
    order.meetings = needed();
    std::vector<double> now(conflicts_.machines(), 0.0);
    std::vector<std::size_t> at(conflicts_.machines(), 0);
    order.waitS.assign(conflicts_.machines(), 0.0);
    const auto arrive = [&](std::size_t machine, std::size_t rest) {
      now[machine] += sums_[machine][rest] - sums_[machine][at[machine]];
      at[machine] = rest;
    };
    for (const Rendezvous& r : order.meetings) {
      arrive(r.first, r.firstRest);
      arrive(r.second, r.secondRest);
      const double both = std::max(now[r.first], now[r.second]);
      for (const std::size_t machine : {r.first, r.second})
        order.waitS[machine] += both - std::exchange(now[machine], both);
    }
    for (std::size_t machine = 0; machine < now.size(); ++machine) {
      arrive(machine, conflicts_.segments(machine));
      order.seconds = std::max(order.seconds, now[machine]);
    }
    return order;
  }

private:
  // Returns the moments at which one of the machines inserted reaches a rest, in their order.
  std::vector<Cut> cuts() const {
    struct Arrival {
      double timeS;
      std::size_t barriers; // that the machine has passed: orders arrivals at the same moment
      std::size_t machine, rest;
    };
    std::vector<Arrival> arrivals;
    std::vector<double> now(conflicts_.machines(), 0.0);
    std::vector<std::size_t> at(conflicts_.machines(), 0), passed(conflicts_.machines(), 0);
    const auto move = [&](std::size_t machine, std::size_t to) {
      const std::vector<double>& sums = sums_[machine];
      const double begin = now[machine] - sums[at[machine]];
      for (std::size_t rest = at[machine] + 1; rest <= to; ++rest)
        arrivals.push_back({begin + sums[rest], passed[machine], machine, rest});
      now[machine] = begin + sums[to];
      at[machine] = to;
    };
    for (std::size_t b = 0; b < barriers_.size(); ++b) {
      double all = 0.0;
      for (const std::size_t machine : included_)
        if (barriers_[b][machine] != kAbsent) {
          move(machine, barriers_[b][machine]);
          all = std::max(all, now[machine]);
        }
      for (const std::size_t machine : included_)
        if (barriers_[b][machine] != kAbsent) {
          now[machine] = all;
          passed[machine] = b + 1;
        }
    }
    for (const std::size_t machine : included_)
      move(machine, conflicts_.segments(machine));
    std::ranges::sort(arrivals, {}, [](const Arrival& a) {
      return std::tuple(a.timeS, a.barriers, a.machine, a.rest);
    });
    std::vector<Cut> cuts(1, {0.0, std::vector<std::size_t>(conflicts_.machines(), 0), 0});
    for (const Arrival& arrival : arrivals) {
      Cut cut = cuts.back();
      cut.timeS = arrival.timeS;
      cut.machine = arrival.machine;
      cut.rest[arrival.machine] = arrival.rest;
      cuts.push_back(std::move(cut));
    }
    return cuts;
  }

  // Returns the conflicts of all machines inserted, as one with a segment from each cut to the
  // next, with the machine to be inserted.
  Conflicts against(std::size_t machine, const std::vector<Cut>& cuts) const {
    const std::size_t a = cuts.size() - 1, b = conflicts_.segments(machine);
    Conflicts all{a, b, Flags(a, b), Flags(a + 1, b), Flags(a, b + 1)};
    for (std::size_t s = 0; s <= a; ++s)
      for (std::size_t j = 0; j <= b; ++j) {
        const auto hinders = [&](std::size_t other) {
          return conflicts_.hinders(other, cuts[s].rest[other], machine, j);
        };
        const bool rests = j < b && std::ranges::any_of(included_, hinders);
        if (rests)
          all.aRests.set(s, j);
        if (s == a)
          continue;
        const std::size_t moved = cuts[s + 1].machine, segment = cuts[s].rest[moved];
        if (conflicts_.hinders(machine, j, moved, segment))
          all.bRests.set(s, j);
        if (j < b && (rests || conflicts_.meet(moved, segment, machine, j)))
          all.moving.set(s, j);
      }
    return all;
  }

  // Adds a barrier of all machines at the end of each phase but the last.
  void addBarriers(std::size_t machine, const std::vector<Cut>& cuts, const Schedule& schedule) {
    std::vector<Barrier> barriers;
    std::vector<char> placed(barriers_.size(), 0);
    for (std::size_t p = 0; p + 1 < schedule.phases.size(); ++p) {
      Barrier added(conflicts_.machines(), kAbsent);
      const Cut& cut = cuts[schedule.phases[p].aTo];
      for (const std::size_t other : included_)
        added[other] = cut.rest[other];
      added[machine] = schedule.phases[p].bTo;
      const auto isBefore = [&](const Barrier& barrier) {
        return std::ranges::all_of(included_, [&](std::size_t other) {
          return barrier[other] == kAbsent || barrier[other] <= added[other];
        });
      };
      for (std::size_t b = 0; b < barriers_.size(); ++b)
        if (!placed[b] && isBefore(barriers_[b])) {
          barriers.push_back(barriers_[b]);
          placed[b] = 1;
        }
      barriers.push_back(std::move(added));
    }
    for (std::size_t b = 0; b < barriers_.size(); ++b)
      if (!placed[b])
        barriers.push_back(barriers_[b]);
    barriers_ = std::move(barriers);
  }

  // Returns the rendezvous of pairs at the barriers, without those that the pair does not need. All
  // pairs of a barrier, in one order for all machines, let none go on before all are there.
  std::vector<Rendezvous> needed() const {
    std::vector<std::pair<std::size_t, Rendezvous>> kept; // with the number of the barrier
    for (std::size_t j = 1; j < conflicts_.machines(); ++j)
      for (std::size_t i = 0; i < j; ++i) {
        const Conflicts& table = conflicts_.of(i, j);
        Phase phase;                  // since the last rendezvous kept
        std::size_t before = kAbsent; // barrier at its end
        const auto end = [&](std::size_t iRest, std::size_t jRest) {
          const Phase longer{phase.aFrom, iRest, phase.bFrom, jRest};
          if (before != kAbsent && !isFree(table, longer)) {
            kept.push_back({before, {i, j, phase.aTo, phase.bTo}});
            phase.aFrom = phase.aTo;
            phase.bFrom = phase.bTo;
          }
          phase.aTo = iRest;
          phase.bTo = jRest;
        };
        for (std::size_t b = 0; b < barriers_.size(); ++b)
          if (barriers_[b][i] != kAbsent && barriers_[b][j] != kAbsent) {
            end(barriers_[b][i], barriers_[b][j]);
            before = b;
          }
        end(conflicts_.segments(i), conflicts_.segments(j));
      }
    std::ranges::sort(kept, {}, [](const auto& k) {
      return std::tuple(k.first, k.second.first, k.second.second);
    });
    std::vector<Rendezvous> meetings;
    for (const auto& [barrier, rendezvous] : kept)
      meetings.push_back(rendezvous);
    return meetings;
  }

  const PairConflicts& conflicts_;
  const std::vector<std::vector<double>>& sums_;
  double markS_;
  std::vector<std::size_t> included_;
  std::vector<Barrier> barriers_;
};
} // namespace

std::optional<Order> orderOf(const PairConflicts& conflicts,
                             const std::vector<std::vector<double>>& secondsOf, double markS,
                             const base::RunContext& ctx) {
  const std::size_t machines = conflicts.machines();
  base::require(secondsOf.size() == machines, "orderOf: durations of every machine");
  const std::vector<std::vector<double>> sums = sumsOf(secondsOf);
  const auto costOf = [&](const Order& order) {
    return order.seconds + markS * static_cast<double>(order.meetings.size());
  };
  std::optional<Order> best;
  const std::size_t beginnings = machines == 2 ? 1 : machines;
  for (std::size_t begin = 0; begin < beginnings; ++begin) {
    Insertion insertion(conflicts, sums, markS);
    bool fits = true;
    for (std::size_t k = 0; k < machines && fits; ++k) {
      ctx.checkpoint();
      fits = insertion.insert((begin + k) % machines);
    }
    if (!fits)
      continue;
    Order order = insertion.order();
    if (!best || costOf(order) < costOf(*best))
      best = std::move(order);
  }
  return best;
}

} // namespace voluta::together
