#include "plan/fitted_tools.h"

#include <algorithm>

namespace voluta::plan {

bool isFittedByHand(const Trajectory& trajectory, int tool) {
  return std::ranges::any_of(trajectory.events, [&](const TrajectoryEvent& event) {
    const TrajectoryEvent* change =
        event.kind == EventKind::Pause ? trajectory.changeAfter(event) : nullptr;
    return change != nullptr && change->tool == tool;
  });
}

} // namespace voluta::plan
