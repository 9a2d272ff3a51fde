// Writer and reader of lines that a computer sends to a KUKA controller by KUKA.EthernetKRL (EKI,
// TCP), together with the program that receives them and the script that sends them
// (docs/programs.md).
//
//   NAME.eki             the lines, which are verified (program/stream/link_rows.h)
//   print_NAME_eki.src   KRL: to the start after HALT, then EKI_GetReal, motion, answer in a loop
//   print_NAME_eki.dat   the variables it reads into
//   print_NAME_eki.xml   EKI's channel: the robot is the server; record format and buffer size
//   NAME_eki.py          Python 3, standard library: sends each line as an XML record, with a
//                        limited number of unanswered records
//
// Lines are "X_mm,Y_mm,Z_mm,A_deg,B_deg,C_deg,mm_per_s,deg_per_s,flow,blend_mm", preceded by the
// frames `tool`, `base` or `nozzle`, and `load`. Frames and speeds are as in the krl dialect
// (program/krl/krl.h): LIN of $TOOL in $BASE, or of the nozzle on the part with $IPO_MODE=#TCP;
// $OUT[1] where the arm is at rest, $ANOUT[1] by TRIGGER at the start of a motion; C_DIS. Other
// files given together with the lines must match those that the lines produce.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"
#include "program/stream/link_rows.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Returns the form of its lines.
const LinkForm& krlLinkForm();

plan::Program writeKrlEki(const ProgramInput& input, const base::RunContext& ctx);
// `complete`: the lines are complete.
plan::ReadProgram readKrlEki(const std::vector<plan::ProgramFile>& files,
                             const process::Tooling& tooling, const base::RunContext& ctx);
bool looksLikeKrlEki(std::string_view text);
std::vector<std::string> filesOfKrlEki(std::string_view text);                   // See Dialect.
bool mayBeMissingInKrlEki(const std::vector<std::string>& lines, std::size_t i); // See Dialect.

} // namespace voluta::program
