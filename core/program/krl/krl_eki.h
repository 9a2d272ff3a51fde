// Lines that a computer sends a KUKA controller by KUKA.EthernetKRL (EKI, TCP), with the program
// that takes them and the one that sends them beside it (docs/programs.md).
//
// NAME.eki             what is judged: a motion a line (program/stream/link_rows.h)
// print_NAME_eki.src   KRL: to the start behind HALT, then EKI_GetReal, motion, answer, in turn
// print_NAME_eki.dat   what it reads into
// print_NAME_eki.xml   EKI's channel: the robot serves, what a record is, how many it keeps
// NAME_eki.py          Python 3, standard library: sends each line as an XML record, no more than
//                      so many ahead of the answers
//
// Lines are "X_mm,Y_mm,Z_mm,A_deg,B_deg,C_deg,mm_per_s,deg_per_s,flow,blend_mm", with frames
// `tool`, `base` or `nozzle`, and `load` before them. What is moved, and how fast, is as of the krl
// dialect (program/krl/krl.h): LIN of $TOOL in $BASE, of the nozzle on the part with
// $IPO_MODE=#TCP; $OUT[1] where the arm stands, $ANOUT[1] by TRIGGER at a motion's beginning;
// C_DIS. Files given beside the lines have to be what these lines make.
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
const LinkForm& krlLinkForm();

plan::Program writeKrlEki(const ProgramInput& input, const base::RunContext& ctx);
// `complete`: the lines came to their end.
plan::ReadProgram readKrlEki(const std::vector<plan::ProgramFile>& files,
                             const process::Process& process, const base::RunContext& ctx);
bool looksLikeKrlEki(std::string_view text);
std::vector<std::string> filesOfKrlEki(std::string_view text);                   // Dialect
bool mayBeMissingInKrlEki(const std::vector<std::string>& lines, std::size_t i); // Dialect

} // namespace voluta::program
