// Order of work of two machines: phases, with a mark between two of them at which both meet.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace voluta::together {

// A table of yes and no.
class Flags {
public:
  Flags() = default;
  Flags(std::size_t rows, std::size_t columns) : columns_(columns), flags_(rows * columns, 0) {}
  bool at(std::size_t row, std::size_t column) const {
    return flags_[row * columns_ + column] != 0;
  }
  void set(std::size_t row, std::size_t column) { flags_[row * columns_ + column] = 1; }

private:
  std::size_t columns_ = 0;
  std::vector<char> flags_;
};

// Which segments must not happen at the same time. Machine A has a segments, B has b; a rest is the
// start of the segment with its number, or the end of the last.
struct Conflicts {
  std::size_t a = 0, b = 0;
  Flags moving; // a x b: both move
  Flags aRests; // (a + 1) x b: A rests there, B moves
  Flags bRests; // a x (b + 1): A moves, B rests there
};

// Machine A runs segments [aFrom, aTo) and B runs [bFrom, bTo), in any relation of time; the one
// that ends first waits for the other.
struct Phase {
  std::size_t aFrom = 0, aTo = 0, bFrom = 0, bTo = 0;
};
// Returns whether no segments of the phase conflict; of a machine that runs none, its rest counts.
bool isFree(const Conflicts& conflicts, const Phase& phase);

struct Schedule {
  std::vector<Phase> phases;
  double seconds = 0.0; // sum of the longer of both times of each phase

  std::size_t marks() const { return phases.empty() ? 0 : phases.size() - 1; }
};

// Returns the schedule of least time plus markS for each mark: exact, by dynamic programming over
// the pairs of rests, if the tables are small (kExactSteps); with more segments a phase is at most
// so long that the number of steps stays below it. Phases that can be one are joined. nullopt if
// there is no schedule. aS, bS: durations of the segments [s]. Precondition: their numbers are a
// and b.
inline constexpr double kExactSteps = 4e8;
std::optional<Schedule> fastestSchedule(const Conflicts& conflicts, std::span<const double> aS,
                                        std::span<const double> bS, double markS);

// Returns the furthest pair of rests that both can reach without meeting: the last one of the
// largest sum.
std::pair<std::size_t, std::size_t> furthestReached(const Conflicts& conflicts);

} // namespace voluta::together
