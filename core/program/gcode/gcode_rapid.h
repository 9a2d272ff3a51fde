// A RAPID module that reads extended G-code on an ABB controller (Castelli 2020, 3.2.1,
// "Stand-alone": the controller reads the file and controls the extruder). Written beside the
// G-code if its option requests it.
//
// The module opens HOME:NAME.gcode and turns each block into a motion of the nozzle in the work
// object and a flow of the extruder's outputs: G0, G1 with X Y Z, nX nY nZ, E, F; G92 E; G4. It
// skips the other words that this dialect writes and stops at unknown ones. A motion waits for the
// next block, so that beads continue without a stop. As the G-code does not state the tool's
// rotation about the nozzle's axis, the module rotates it from the start orientation, the shortest
// way.
//
// The job's own data (names, tool, work object, start, full flow) come before kRapidGcodeSame; the
// text after it is the same for every job.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_builder.h"
#include "program/program_input.h"

#include <string>
#include <string_view>

namespace voluta::program {

// The companion reader: none, or this module.
base::ParameterSpec gcodeRunner();
bool wantsRapidRunner(const ProgramOptions& options);

inline constexpr std::string_view kRapidGcodeNote = "read on an ABB controller by ";
std::string rapidRunnerName(const ProgramInput& input); // of the file

// Throws Error{Usage} if the cell has external axes, which G-code does not state. Throws Cancelled.
plan::ProgramFile rapidRunner(const ProgramInput& input, std::string_view gcodeFile,
                              const base::RunContext& ctx);

// isRapidRunner: returns whether a text is such a module. readRapidRunner: reports its deviations
// to `out`, whose file is set.
bool isRapidRunner(std::string_view text);
void readRapidRunner(std::string_view text, const process::Tooling& tooling, ProgramBuilder& out,
                     const base::RunContext& ctx);

} // namespace voluta::program
