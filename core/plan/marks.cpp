#include "plan/marks.h"

#include "plan/trajectory.h"

#include <array>

namespace voluta::plan {

std::vector<int> markSignalsOf(const Trajectory& trajectory) {
  std::array<bool, kMarkChannels> used{};
  for (const TrajectoryEvent& event : trajectory.events)
    if (event.kind == EventKind::Mark)
      used.at(static_cast<std::size_t>(event.tool)) = true;
  std::vector<int> signals;
  for (int channel = 0; channel < kMarkChannels; ++channel)
    if (used[static_cast<std::size_t>(channel)])
      signals.insert(signals.end(), {2 * channel, 2 * channel + 1});
  return signals;
}

} // namespace voluta::plan
