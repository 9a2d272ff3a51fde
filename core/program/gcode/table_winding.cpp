#include "program/gcode/table_winding.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace voluta::program {

namespace {

constexpr double kTurn = 2.0 * base::kPi;
constexpr double kSlackRad = 1e-9; // of rounded angles

// The whole turns that bring a stretch within the limit; none if least > most.
struct Turns {
  double least, most;
};
Turns within(const TurnRange& stretch, double mostRad) {
  return {std::ceil((-mostRad - stretch.lowest - kSlackRad) / kTurn),
          std::floor((mostRad - stretch.highest + kSlackRad) / kTurn)};
}

} // namespace

std::vector<int> windings(std::span<const TurnRange> stretches, double mostRad) {
  std::vector<int> turns;
  turns.reserve(stretches.size());
  double last = 0.0;
  while (turns.size() < stretches.size()) {
    // Extend the run as long as one number of turns suits all stretches.
    std::size_t end = turns.size();
    Turns common = within(stretches[end], mostRad);
    if (common.least > common.most) {
      const TurnRange& wide = stretches[end];
      common.least = common.most = -std::round(0.5 * (wide.lowest + wide.highest) / kTurn);
      ++end;
    } else {
      for (Turns next = common; end < stretches.size() && next.least <= next.most;) {
        common = next;
        if (++end < stretches.size()) {
          const Turns own = within(stretches[end], mostRad);
          next = {std::max(common.least, own.least), std::min(common.most, own.most)};
        }
      }
    }
    last = std::clamp(last, common.least, common.most);
    turns.resize(end, static_cast<int>(last));
  }
  return turns;
}

bool fitWithin(std::span<const TurnRange> stretches, double mostRad) {
  return std::ranges::all_of(stretches, [&](const TurnRange& stretch) {
    const Turns turns = within(stretch, mostRad);
    return turns.least <= turns.most;
  });
}

int leastTurns(std::span<const TurnRange> stretches) {
  int most = 1;
  while (!fitWithin(stretches, most * kTurn))
    ++most;
  return most;
}

} // namespace voluta::program
