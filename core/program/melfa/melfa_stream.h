// A stream of joints for Mitsubishi controllers by real-time control (Mxt), with the program that
// receives it and the script that sends it (BFP-A3379; docs/programs.md).
//
//   NAME.rows       the verified rows of joints over time (program/stream/joint_rows.h)
//   NAME.mxt        those rows as packets (program/melfa/mxt_packets.h), one per controller cycle
//   NAME_mxt.prg    MELFA-BASIC: to the start after Hlt, then Mxt
//   NAME_mxt.py     Python 3, standard library: sends the packets, one per answer
//
// Files given with the rows must match those generated from the rows.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Returns the parameter for the controller, which determines the cycle.
base::ParameterSpec mxtController();
std::vector<base::ParameterSpec> melfaStreamOptions();

// Throws Error{Usage} for a stream with too many packets for a file.
plan::Program writeMelfaStream(const ProgramInput& input, const base::RunContext& ctx);
// `complete`: the rows are complete.
plan::ReadProgram readMelfaStream(const std::vector<plan::ProgramFile>& files,
                                  const process::Tooling& tooling, const base::RunContext& ctx);
bool looksLikeMelfaStream(std::string_view text);
std::vector<std::string> filesOfMelfaStream(std::string_view text); // See Dialect

} // namespace voluta::program
