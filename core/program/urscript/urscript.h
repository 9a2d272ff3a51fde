// URScript for Universal Robots controllers (docs/programs.md; URScript manual).
//
// A written program is one function with a set-up (set_tcp with the cell's flange_T_moved,
// set_payload, the output's domain), the trajectory and an end, followed by its call unless it is
// for a port (urscriptForm). Units are metres, radians and seconds. One line per point:
//   Print, Linear  movel(p[x,y,z,rx,ry,rz], a=, t=, r=): pose of the TCP in Base. Between two poses
//                  the controller moves the TCP straight and rotates it the shortest way. t takes
//                  precedence over v and a, for distance and rotation alike (a speed would leave
//                  the
//                  rotation to a limit of the controller); a is the acceleration required by ramps
//                  and blends. v= where no time is known.
//   Joint          movej([q...], a=, v=), with the cell's travelAcceleration as a, and as v the
//                  speed of the leading joint at which the motion from rest to rest takes the
//                  planned time; movej(p[...]) in a program for another maker's robot. The first
//                  point is always a movej, at kStartRadPerS, after a popup that asks the operator.
//                  The extruder is on while standard digital output 0 is on, with a flow of
//                  (standard analogue output 0, in 0..1, 0 to 10 V) x the full flow. Flow
//                  and times: TcpMotions. Blends (program/common/tcp_motions.h) only between Print
//                  motions or straight travels. Priming: once, at the first point, before any
//                  further motion; the extruder runs for process.primeS. A program of more than
//                  kMotionsPerScript motions (or motionsPerFile) is split: for a file node into a
//                  file that calls the functions of the others, whose nodes precede it; for a port
//                  into files that are sent in turn.
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
// Standard digital output of the tape's cutter, which cuts when it turns on.
inline constexpr int kCutOutput = 7;
// Default for file nodes. No limit is published; controllers slow down from some thousand lines on.
inline constexpr std::size_t kMotionsPerScript = 5000;
// Marks a program whose function is called after its end, so that a missing call is detected.
inline constexpr std::string_view kCalledNote = "# called in the last line";

// Marks a file that a program calls and that does nothing by itself.
inline constexpr std::string_view kPartNote = "# a part, called by ";
// Marks a file that is sent to a port; the name of the next file to be sent follows.
inline constexpr std::string_view kNextNote = "# when it has ended, send ";

// Return the parameters motionsPerFile and urscriptForm: for a file node, or sent to a port, where
// `end` is the last line and nothing calls the function.
base::ParameterSpec urscriptForm();
std::vector<base::ParameterSpec> urscriptOptions();

plan::Program writeUrscript(const ProgramInput& input, const base::RunContext& ctx);

// Reads def/end, calls of the functions named above, movep (as movel with a blend), sleep, outputs
// by set_[standard_]digital_out and set_[standard_]analog_out, and urscriptWords(); positional and
// named arguments in any order, spaces, comments, CR LF. Anything else is a defect. Functions of
// any file may be called; a file that is a part runs only if called, all other files run by
// themselves in their order. `complete`: every function is closed by `end` and, where the text
// contains kCalledNote, called, and the extruder's two outputs are off after the last motion.
plan::ReadProgram readUrscript(const std::vector<plan::ProgramFile>& files,
                               const process::Tooling& tooling, const base::RunContext& ctx);
// Returns the other words that a program may contain, and where; all others are refused.
std::span<const KnownWord> urscriptWords();
bool looksLikeUrscript(std::string_view text);
std::vector<std::string> filesOfUrscript(std::string_view text);                   // See Dialect
bool mayBeMissingInUrscript(const std::vector<std::string>& lines, std::size_t i); // See Dialect

} // namespace voluta::program
