#include "program/gcode/table_winding.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace voluta::program {

namespace {

constexpr double kTwoPi = 2.0 * base::kPi;
constexpr double kSlackRad = 1e-9; // of rounded angles

// The whole turns that bring a stretch within the limit; none if minimum > maximum.
struct Turns {
  double minimum, maximum;
};
Turns within(const AngleRange& stretch, double maxRad) {
  return {std::ceil((-maxRad - stretch.lowest - kSlackRad) / kTwoPi),
          std::floor((maxRad - stretch.highest + kSlackRad) / kTwoPi)};
}

} // namespace

std::vector<int> windings(std::span<const AngleRange> stretches, double maxRad) {
  std::vector<int> turns;
  turns.reserve(stretches.size());
  double last = 0.0;
  while (turns.size() < stretches.size()) {
    // Extend the run as long as one number of turns suits all stretches.
    std::size_t end = turns.size();
    Turns common = within(stretches[end], maxRad);
    if (common.minimum > common.maximum) {
      const AngleRange& wide = stretches[end];
      common.minimum = common.maximum = -std::round(0.5 * (wide.lowest + wide.highest) / kTwoPi);
      ++end;
    } else {
      for (Turns next = common; end < stretches.size() && next.minimum <= next.maximum;) {
        common = next;
        if (++end < stretches.size()) {
          const Turns own = within(stretches[end], maxRad);
          next = {std::max(common.minimum, own.minimum), std::min(common.maximum, own.maximum)};
        }
      }
    }
    last = std::clamp(last, common.minimum, common.maximum);
    turns.resize(end, static_cast<int>(last));
  }
  return turns;
}

bool fitWithin(std::span<const AngleRange> stretches, double maxRad) {
  return std::ranges::all_of(stretches, [&](const AngleRange& stretch) {
    const Turns turns = within(stretch, maxRad);
    return turns.minimum <= turns.maximum;
  });
}

int minRevolutions(std::span<const AngleRange> stretches) {
  int revolutions = 1;
  while (!fitWithin(stretches, revolutions * kTwoPi))
    ++revolutions;
  return revolutions;
}

} // namespace voluta::program
