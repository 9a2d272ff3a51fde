// A replay in two steps, for a caller that has results of the same run already (KnownResults).
// Together, with nothing known, they are replayProgram().
#pragma once

#include "replay/comparison.h"
#include "replay/program_run.h"
#include "replay/verification.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// A program after the first step: its run, and all results that depend on its text.
struct ComparedProgram {
  Run run;
  // Contains the deviations and their findings, times and masses, the places of motions, and the
  // worst deviation and flow error. The figures of the run are still missing.
  Verification verdict;
  std::vector<TextFinding> times, limits; // to be listed after those of beads and of collisions
  double standingMm3 = 0.0;               // deposited while the arm is at rest
  std::size_t deviationMotion = 0;        // motion with the largest distance from the planned path
};

struct JudgedProgram {
  Verification verdict;
  JudgedRun run;
};

// Runs the program and compares its text with the plan. Frees the motions of `input.program`, which
// the second step does not read. Preconditions and Cancelled as for replayProgram(). Reports the
// first tenth of the progress.
ComparedProgram compareProgram(ReplayInput& input, const ReplayThresholds& thresholds,
                               const base::RunContext& ctx);

// Judges the run (judgeRun) and concludes the verdict. Precondition: `input` and `thresholds` are
// those of the first step. Throws Cancelled.
JudgedProgram judgeProgram(ComparedProgram compared, const ReplayInput& input,
                           const ReplayThresholds& thresholds, KnownResults known,
                           const base::RunContext& ctx);

} // namespace voluta::replay
