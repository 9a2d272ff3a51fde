// Runs shared by the programs of one plan. The programs state the same motions in several
// languages; beads that are the same are deposited and judged once.
#pragma once

#include "process/process.h"
#include "replay/program_run.h"
#include "replay/verification.h"

#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::pipeline {

class SharedRuns {
public:
  // Returns the results for `run` of the first run here that deposits the same beads: the beads,
  // and the clashes of unchanged motions. Returns nothing known if there is none.
  //
  // Motions are unchanged if tip and head stay within half a cell of the bead grid (contacts are
  // not resolved more finely) and, for clashes of the arm, its joints agree. Beads are the same if
  // all extruding motions have a counterpart with the same material and are, weighted by volume, at
  // most a tenth of a cell apart in the mean. Precondition: the runs here were judged against the
  // same part, platform, cell and process, by the same thresholds. Throws Cancelled.
  replay::KnownResults knownOf(const replay::Run& run, const process::Process& process,
                               const base::RunContext& ctx) const;

  // Adds a run without the data that no other run needs: its targets, lengths and durations, its
  // points and their knowledge.
  void add(replay::JudgedRun run);

  const std::vector<replay::JudgedRun>& runs() const { return runs_; }

private:
  std::vector<replay::JudgedRun> runs_;
};

// As replay::replayProgram(), but takes known results from `shared` and adds the program's run. The
// text and the limits are checked in any case.
replay::Verification replayShared(replay::ReplayInput input,
                                  const replay::ReplayThresholds& thresholds, SharedRuns& shared,
                                  const base::RunContext& ctx);

} // namespace voluta::pipeline
