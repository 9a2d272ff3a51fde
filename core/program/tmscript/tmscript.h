// TMscript for Techman controllers, as frames that a listen node takes (tmscript_frames.h;
// docs/programs.md).
//
// Written: one frame a line, one statement a frame, numbered by its name; lines that begin with //
// are not to be sent. mm, degrees, seconds; poses of the TCP in the robot's base, R = Rz Ry Rx.
// Per point one statement:
//   Print, Linear  PVTPoint(pose, velocity, seconds) between PVTEnter(1) and PVTExit(): where, how
//                  fast there and how long the way takes (pvt_velocities.h); the angles go on
//                  beyond half a turn rather than jump. 0 where the arm stands.
//   Joint          PTP("JPP",...) per cent of kTmJointRadPerS, a whole number; PTP("CPP",...) to a
//                  pose in a program for another maker's robot. The first point is reached at
//                  kTmStartPercent, behind Pause().
// The extruder is on while digital output 0 of the control box is, with a flow of its analogue
// output 0, 10 V for process.maxFlowMm3PerS, both queued with the motions. Prime: a point of PVT
// where the arm stands.
#pragma once

#include "base/run_context.h"
#include "base/units.h"
#include "plan/program.h"
#include "program/common/known_words.h"
#include "program/program_input.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// What 100 % of a joint motion is taken for: axes 1 to 3 of a TM5.
inline constexpr double kTmJointRadPerS = base::kPi;
inline constexpr int kTmStartPercent = 8;
inline constexpr double kTmFullVolts = 10.0;

plan::Program writeTmscript(const ProgramInput& input, const base::RunContext& ctx);

// Understood: frames of one or more lines, statements without a frame, // remarks; PVTEnter,
// PVTPoint, PVTExit, PTP, Line and PLine, poses and joints as numbers, lists or variables;
// ChangeTCP and ChangeBase by their numbers, ChangeLoad, IO of the control box, ScriptExit and
// tmscriptWords(). Everything else is a defect, and so are frames of another length or checksum,
// speeds of Line that are no whole numbers, and velocities that lead PVT off its line. Below
// kTmLeastPercent a whole number says too little of a PTP's time: it has none. `complete`: it ends
// with ScriptExit, the extruder's outputs off behind the last motion.
plan::ReadProgram readTmscript(const std::vector<plan::ProgramFile>& files,
                               const process::Process& process, const base::RunContext& ctx);
inline constexpr double kTmLeastPercent = 12.0;
// What else may stand in a program, and where; everything else is refused.
std::span<const KnownWord> tmscriptWords();
bool looksLikeTmscript(std::string_view text);

} // namespace voluta::program
