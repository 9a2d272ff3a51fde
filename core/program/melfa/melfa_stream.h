// A stream of joints for Mitsubishi controllers by real-time control (Mxt), with the program that
// takes it and the one that sends it beside it (BFP-A3379; docs/programs.md).
//
// NAME.rows       what is judged: rows of joints over time (program/stream/joint_rows.h)
// NAME.mxt        those rows as packets (program/melfa/mxt_packets.h), one a cycle of the
// controller NAME_mxt.prg    MELFA-BASIC: to the start behind Hlt, then Mxt NAME_mxt.py     Python
// 3, standard library: sends the packets, one for each answer
//
// Files given beside the rows have to be what these rows make.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// The controller, and with it its cycle.
base::ParameterSpec mxtController();
std::vector<base::ParameterSpec> melfaStreamOptions();

// Throws Error{Usage} for one that lasts so long that no file should hold its packets.
plan::Program writeMelfaStream(const ProgramInput& input, const base::RunContext& ctx);
// `complete`: the rows came to their end.
plan::ReadProgram readMelfaStream(const std::vector<plan::ProgramFile>& files,
                                  const process::Process& process, const base::RunContext& ctx);
bool looksLikeMelfaStream(std::string_view text);
std::vector<std::string> filesOfMelfaStream(std::string_view text); // Dialect

} // namespace voluta::program
