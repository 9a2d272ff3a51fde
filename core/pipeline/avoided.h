// Accumulates the waypoints that motion planning skips because a replay found collisions there.
#pragma once

#include "plan/tool_plan.h"

#include <cstddef>
#include <set>
#include <vector>

namespace voluta::pipeline {

// The skipped waypoints of one program over the rounds of replay and motion planning.
class Avoided {
public:
  // Returns the waypoints to skip next: those of `met`, the colliding waypoints of this round's
  // replay, that no earlier round reported; sorted, without duplicates. If a new waypoint is
  // adjacent to a skipped one, the nozzle would approach where the path now begins, or depart where
  // it now ends, and collide again. Therefore additional waypoints of that path are skipped beyond
  // it; their number doubles from round to round: 1, 3, 7 ... Precondition: `met` are waypoints of
  // the plan.
  std::vector<std::size_t> next(const plan::ToolPlan& plan, const std::vector<std::size_t>& met);

private:
  std::set<std::size_t> all_;
  std::size_t beyond_ = 0; // Additional waypoints skipped next to skipped ones
};

} // namespace voluta::pipeline
