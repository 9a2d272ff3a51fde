// How far the motions of two runs of one plan are apart.
#pragma once

#include "replay/alignment.h"
#include "replay/program_run.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::pipeline {

// The distance of a motion in one run from the motion to the same point of the plan in another.
struct Apart {
  std::size_t motion = replay::kUnmatched; // of the other run; kUnmatched: none
  double tipMm = 0.0;  // maximum distance of the tip from the other's path, in both directions
  double headMm = 0.0; // same for the far end of the head
};
// Returns an entry per motion of b, compared with the motions of a by their common points.
// `reachMm`: of the head along its axis. Throws Cancelled.
std::vector<Apart> apart(const replay::Run& a, const replay::Run& b, double reachMm,
                         const base::RunContext& ctx);

} // namespace voluta::pipeline
