// A stream of joints for Universal Robots controllers, with the programs that receive and send it
// (URScript manual, servoj and sockets; docs/programs.md).
//
// NAME.joints            is checked: rows of joints over time (program/stream/joint_rows.h)
// NAME_receiver.script   reads rows from a socket and moves the arm by servoj, each controller
// cycle
//                        interpolating between the joints of two rows; standard digital output 0
//                        and
//                        analogue output 0 as in URScript (program/urscript/urscript.h)
//                        NAME_sender.py         Python 3, standard library: sends the receiver to
//                        the robot's port 30002
//                        and the rows to the receiver
//
// The last two are the same for every job except for the receiver's head: remarks, its name and
// set_payload. Files read together with the rows have to match them.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

plan::Program writeUrscriptStream(const ProgramInput& input, const base::RunContext& ctx);
// `complete`: the end of the rows was found.
plan::ReadProgram readUrscriptStream(const std::vector<plan::ProgramFile>& files,
                                     const process::Tooling& tooling, const base::RunContext& ctx);
bool looksLikeUrscriptStream(std::string_view text);
std::vector<std::string> filesOfUrscriptStream(std::string_view text); // Dialect

} // namespace voluta::program
