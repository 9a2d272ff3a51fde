// What a motion is planned without because replays found that something meets there.
#pragma once

#include "plan/tool_plan.h"

#include <cstddef>
#include <set>
#include <vector>

namespace voluta::pipeline {

// Of one program's journey through rounds of replay and motion.
class Avoided {
public:
  // What a round's replay met and no earlier one did, and is to be left out next; in order, once
  // each. Where it lies beside what was left out before, the nozzle comes down where the path now
  // begins or goes up where it now ends, and meets again what it met: so of that path as many more
  // are left out beyond it as the rounds before doubled to, 1, 3, 7 ... Precondition: waypoints of
  // the plan.
  std::vector<std::size_t> next(const plan::ToolPlan& plan, const std::vector<std::size_t>& met);

private:
  std::set<std::size_t> all_;
  std::size_t beyond_ = 0; // waypoints, of what lies beside what was left out
};

} // namespace voluta::pipeline
