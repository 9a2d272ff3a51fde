// A RAPID module that reads extended G-code on an ABB controller (Castelli 2020, 3.2.1,
// "Stand-alone": the controller reads the file and masters the extruder). Beside the G-code where
// its row's option asks for it.
//
// The module opens HOME:NAME.gcode and makes of each block a motion of the nozzle in the work
// object and a flow of the extruder's outputs: G0, G1 with X Y Z, nX nY nZ, E, F; G92 E; G4. All
// else that this dialect writes is skipped, what it does not know stops it. A motion waits for the
// next block, so that beads go on without a stop. Which way the tool stands about the nozzle's axis
// the G-code does not say: the module turns it from where it stands at the start, the shortest way.
//
// What of it is a job's own (names, tool, work object, start, full flow) stands above
// kRapidGcodeSame; from there on it is the same for every job.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_builder.h"
#include "program/program_input.h"

#include <string>
#include <string_view>

namespace voluta::program {

// What reads it: nothing beside it, or this module.
base::ParameterSpec gcodeRunner();
bool wantsRapidRunner(const ProgramOptions& options);

inline constexpr std::string_view kRapidGcodeNote = "read on an ABB controller by ";
std::string rapidRunnerName(const ProgramInput& input); // of the file

// Throws Error{Usage}: the cell has external axes, which G-code does not say. Throws Cancelled.
plan::ProgramFile rapidRunner(const ProgramInput& input, std::string_view gcodeFile,
                              const base::RunContext& ctx);

// Is a text such a module? And what of it is not as it has to be, told to `out`, whose file is set.
bool isRapidRunner(std::string_view text);
void readRapidRunner(std::string_view text, const process::Process& process, ProgramBuilder& out,
                     const base::RunContext& ctx);

} // namespace voluta::program
