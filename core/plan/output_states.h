// The machine's outputs that the events of a trajectory set.
#pragma once

#include "plan/trajectory.h"

#include <cstddef>
#include <map>

namespace voluta::plan {

// Returns each output that any event of the trajectory sets, by its number, with its state behind
// the events before the motion to that point: off until an event sets it. Before the first motion
// it is that at point 0.
inline std::map<int, bool> outputStates(const Trajectory& trajectory, std::size_t point) {
  std::map<int, bool> states;
  for (const TrajectoryEvent& event : trajectory.events)
    if (event.kind == EventKind::Output) {
      bool& on = states.try_emplace(event.tool, false).first->second;
      on = event.point <= point ? event.on : on;
    }
  return states;
}

} // namespace voluta::plan
