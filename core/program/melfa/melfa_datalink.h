// Lines that a computer sends a Mitsubishi controller by data link (TCP), with the program of
// MELFA-BASIC V that takes them and the one that sends them beside it (docs/programs.md).
//
// NAME.lines      what is judged: a motion a line (program/stream/link_rows.h)
// NAME_link.prg   MELFA-BASIC: to the start behind Hlt, then Input #, motion, answer, in turn
// NAME_link.py    Python 3, standard library: sends the lines, no more than a few ahead of the
//                 answers
//
// What is moved, and how fast, is as of the melfa dialect (program/melfa/melfa.h): straight motions
// by Mvs, or EMvs 1 with the nozzle in the world; the flow a number on 16 outputs; blends Cnt
// 1,r,r. Files given beside the lines have to be what these lines make.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"
#include "program/stream/link_rows.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// What its lines are.
const LinkForm& melfaLinkForm();

plan::Program writeMelfaDatalink(const ProgramInput& input, const base::RunContext& ctx);
// `complete`: the lines came to their end.
plan::ReadProgram readMelfaDatalink(const std::vector<plan::ProgramFile>& files,
                                    const process::Process& process, const base::RunContext& ctx);
bool looksLikeMelfaDatalink(std::string_view text);
std::vector<std::string> filesOfMelfaDatalink(std::string_view text);                   // Dialect
bool mayBeMissingInMelfaDatalink(const std::vector<std::string>& lines, std::size_t i); // Dialect

} // namespace voluta::program
