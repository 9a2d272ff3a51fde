// The Replay stage of a job: writes its programs, reads each back and replays it. Planned, resumed
// and joined jobs use it.
#pragma once

#include "pipeline/plan_result.h"
#include "plan/finding.h"
#include "project/report.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::pipeline {

// How a plan in progress takes part in running its programs. By default programs are made and the
// motion stays. The motion of a resumed or of a joined job has to stay: the beads before the place
// of a resumed one are printed and its rest was replayed with the whole print; the order of work
// of joined machines holds for their motions only. A collision then refuses the program.
struct ProgramHooks {
  using Program = std::shared_ptr<const CheckedProgram>;
  // Returns the program of the format: an earlier one, or what `make` returns.
  std::function<Program(const std::string& format, const std::function<Program()>& make)> take;
  // Replaces the job's motion by one without these waypoints, at which a replay found collisions.
  // Returns whether the job still has a motion.
  std::function<bool(const std::vector<std::size_t>& waypoints)> planWithout;
  // Stop as soon as a program fails for a reason that no other motion repairs; formats after it
  // have no program then.
  bool isTrial = false;
};

struct ProgramsOutcome {
  plan::Findings findings; // to be recorded for the Replay stage
  project::Timings timings;
  bool isHopeless = false; // the trial has ended early
};

// Writes the programs of the job in its formats (chosenFormats) into result.checked, one per
// format, and adds their rows and the verdict to the job's report. If a replay finds collisions and
// hooks.planWithout is set, the motion is planned again without their waypoints, at most six times.
// Precondition (Error{Internal}): the job is planned up to its motion. Throws
// as programStage(); Cancelled.
ProgramsOutcome runPrograms(PlanResult& result, const ProgramHooks& hooks,
                            const base::RunContext& ctx);

} // namespace voluta::pipeline
