// Lines that a computer sends to a Mitsubishi controller by data link (TCP), with the MELFA-BASIC V
// program that receives them and the script that sends them (docs/programs.md).
//
//   NAME.lines      the verified motions, one per line (program/stream/link_rows.h)
//   NAME_link.prg   MELFA-BASIC: to the start after Hlt, then Input #, motion, answer in turn
//   NAME_link.py    Python 3, standard library: sends the lines, a few ahead of the answers
//
// Motions and speeds are as in the melfa dialect (program/melfa/melfa.h): straight motions by Mvs,
// or EMvs 1 with a stationary nozzle; the flow as a number on 16 outputs; blends by Cnt 1,r,r.
// Files given with the lines must match those generated from the lines.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"
#include "program/stream/link_rows.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Returns the form of the lines.
const LinkForm& melfaLinkForm();

plan::Program writeMelfaDatalink(const ProgramInput& input, const base::RunContext& ctx);
// `complete`: the lines are complete.
plan::ReadProgram readMelfaDatalink(const std::vector<plan::ProgramFile>& files,
                                    const process::Tooling& tooling, const base::RunContext& ctx);
bool looksLikeMelfaDatalink(std::string_view text);
std::vector<std::string> filesOfMelfaDatalink(std::string_view text); // See Dialect
// See Dialect
bool mayBeMissingInMelfaDatalink(const std::vector<std::string>& lines, std::size_t i);

} // namespace voluta::program
