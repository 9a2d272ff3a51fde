// Order of work of several machines: rendezvous of two machines each, at which both wait for each
// other.
#pragma once

#include "together/schedule.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::together {

// Conflicts of every pair of machines.
class PairConflicts {
public:
  // Preconditions: at least two machines, each with at least one segment.
  explicit PairConflicts(std::vector<std::size_t> segments);

  std::size_t machines() const { return segments_.size(); }
  std::size_t segments(std::size_t machine) const { return segments_[machine]; }
  // The lower machine is A of the table. Precondition: lower < upper < machines().
  const Conflicts& of(std::size_t lower, std::size_t upper) const;
  Conflicts& of(std::size_t lower, std::size_t upper);

  // Returns whether these segments of two machines must not happen at the same time.
  bool meet(std::size_t machine, std::size_t segment, std::size_t other,
            std::size_t otherSegment) const;
  // Returns whether the machine at this rest hinders a segment of the other.
  bool hinders(std::size_t machine, std::size_t rest, std::size_t other,
               std::size_t otherSegment) const;

private:
  std::size_t indexOf(std::size_t lower, std::size_t upper) const;
  std::vector<std::size_t> segments_;
  std::vector<Conflicts> tables_;
};

// Each machine waits at its rest until the other is at its own. first < second.
struct Rendezvous {
  std::size_t first = 0, second = 0;
  std::size_t firstRest = 0, secondRest = 0;
};

struct Order {
  std::vector<Rendezvous> meetings; // every machine passes its own in this order
  double seconds = 0.0;             // until all have ended
  std::vector<double> waitS;        // per machine, at its rendezvous
};

// Between two rendezvous of a pair, all segments of the one are free from all of the other, so the
// order holds for any speeds; it cannot deadlock, as all machines follow one list. Two machines get
// the order of least time plus markS for each rendezvous (fastestSchedule). Further machines are
// inserted one after another into the order of those before, each with the least time, beginning
// with every machine in turn; the best result counts, which need not be the best of all. Rendezvous
// that a pair does not need are dropped. nullopt if no order was found. secondsOf: durations of the
// segments of each machine [s]. Preconditions: one duration per segment. Throws Cancelled.
std::optional<Order> orderOf(const PairConflicts& conflicts,
                             const std::vector<std::vector<double>>& secondsOf, double markS,
                             const base::RunContext& ctx);

} // namespace voluta::together
