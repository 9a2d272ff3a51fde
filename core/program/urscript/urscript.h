// URScript for Universal Robots controllers (docs/programs.md; URScript manual).
//
// Written: one function with a set-up (set_tcp with the cell's flange_T_moved, set_payload, the
// output's domain), the trajectory and an end, then its call unless it is for a port
// (urscriptForm). Metres, radians, seconds. Per point one line:
//   Print, Linear  movel(p[x,y,z,rx,ry,rz], a=, t=, r=): pose of the TCP in Base; between two poses
//                  the controller moves the TCP straight and turns it the shortest way. t rules
//                  over v and a, for way and turn alike (a speed would leave the turn to a limit of
//                  the controller's own); a is what ramps and blends ask for. v= where no time is
//                  known.
//   Joint          movej([q...], a=, v=), a the cell's travelAcceleration, v of the leading joint
//                  at which it takes as long as planned from rest to rest;
//                  movej(p[...]) in a program for another maker's robot. The first point is always
//                  a movej, at kStartRadPerS, behind a popup that asks the operator.
// The extruder is on while standard digital output 0 is, with a flow of (standard analogue output
// 0, in 0..1, 0 to 10 V) x process.maxFlowMm3PerS. Flow and times: TcpMotions. Blends
// (program/common/tcp_motions.h) only between Print motions or straight travels. Prime: once, at
// the first point, before anything moves on; the extruder runs for process.primeS. A program of
// more than kMotionsPerScript motions (or motionsPerFile) is split: for a file node into a file
// that calls the functions of the others, whose nodes stand before it; for a port into files that
// are sent in turn.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/common/known_words.h"
#include "program/program_input.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr double kStartRadPerS = 0.25;
// Of a file unless the user says otherwise. No limit is published; controllers slow down from some
// thousand lines on.
inline constexpr std::size_t kMotionsPerScript = 5000;
// Said by a program whose function is called behind its end, so that the call is missed.
inline constexpr std::string_view kCalledNote = "# called in the last line";

// Said by a file that a program calls: by itself it does nothing.
inline constexpr std::string_view kPartNote = "# a part, called by ";
// Said by a file that is sent to a port; the name of the file to be sent next follows.
inline constexpr std::string_view kNextNote = "# when it has ended, send ";

// motionsPerFile; urscriptForm: for a file node, or sent to a port, where `end` is the last line
// and nothing calls the function.
base::ParameterSpec urscriptForm();
std::vector<base::ParameterSpec> urscriptOptions();

plan::Program writeUrscript(const ProgramInput& input, const base::RunContext& ctx);

// Understood: def/end, calls of the functions named above, movep (as movel with a blend), sleep,
// outputs by set_[standard_]digital_out and set_[standard_]analog_out, and urscriptWords();
// positional and named arguments in any order, spaces, comments, CR LF. Everything else is a
// defect. Functions of any file may be called; a file that is a part runs only so, any other one by
// itself, in their order. `complete`: every function was closed by `end` and, where the text says
// kCalledNote, called, after the extruder's two outputs were set off behind the last motion.
plan::ReadProgram readUrscript(const std::vector<plan::ProgramFile>& files,
                               const process::Process& process, const base::RunContext& ctx);
// What else may stand in a program, and where; everything else is refused.
std::span<const KnownWord> urscriptWords();
bool looksLikeUrscript(std::string_view text);
std::vector<std::string> filesOfUrscript(std::string_view text);                   // Dialect
bool mayBeMissingInUrscript(const std::vector<std::string>& lines, std::size_t i); // Dialect

} // namespace voluta::program
