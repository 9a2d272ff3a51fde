// The Replay stage of one program: writes it, reads it back and replays it.
#pragma once

#include "pipeline/quality.h"
#include "plan/finding.h"
#include "plan/layer_times.h"
#include "process/tooling.h"
#include "program/program_input.h"
#include "program/program_options.h"
#include "replay/verification.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::pipeline {

struct CheckedProgram;
class SharedRuns;

// Input of programStage(). `name`: of the part, without extension.
struct ProgramStageInput {
  const geometry::TriangleMesh& part; // the part to print
  const platform::PlatformSolid& platform;
  const plan::ToolPlan& toolPlan;
  const plan::Trajectory& trajectory;
  const robot::Cell& cell;
  process::Tooling tooling;
  std::string name;
  program::ProgramOptions options = {};
  std::size_t firstPoint = 0; // trajectory point at which the program begins: Job::resumedAt
  std::string job = {};       // as program::ProgramInput::job
  std::vector<std::size_t> commonPoint = {};   // as replay::ReplayInput::commonPoint
  std::vector<std::size_t> firstTriangle = {}; // as replay::ReplayInput::firstTriangle
  std::span<const program::ArcVia> arcs = {};  // as program::ProgramInput::arcs
  replay::WholePlan whole = {};                // before its points were merged
  plan::LayerTimes layerTimes = {};            // as replay::ReplayInput::layerTimes
  Quality quality = {};                        // its limits judge the program
  plan::Findings blockers = {};                // of the plan before its programs: for their heads
};
// Writes the program, reads it back and replays it. If the dialect has no word for an event of the
// trajectory, the program has no files and did not pass. Throws as program::requireOwnRobot and
// program::requireRodTurns. `shared`: results shared by the programs of one motion; null: none.
std::shared_ptr<const CheckedProgram> programStage(const std::string& format,
                                                   const ProgramStageInput& in,
                                                   const base::RunContext& ctx,
                                                   SharedRuns* shared = nullptr);

} // namespace voluta::pipeline
