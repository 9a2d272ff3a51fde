// TMscript for Techman controllers, as frames for a listen node (tmscript_frames.h;
// docs/programs.md).
//
// Written programs have one frame per line and one statement per frame, numbered by its name; lines
// that begin with // are not sent. Units are mm, degrees and seconds; poses are those of the TCP in
// the robot's base, R = Rz Ry Rx. One statement per point:
//   Print, Linear  PVTPoint(pose, velocity, seconds) between PVTEnter(1) and PVTExit(): position,
//                  velocity there and duration of the motion (pvt_velocities.h). Angles continue
//                  beyond half a turn instead of jumping. Velocity 0 where the arm stops.
//   Joint          PTP("JPP",...) in percent of kTmJointRadPerS, an integer; PTP("CPP",...) to a
//                  pose in a program for another maker's robot. The first point is reached at
//                  kTmStartPercent, after Pause(). The extruder is on while digital output 0 of the
//                  control box is on; its flow is analogue output 0, 10 V for
//                  the full flow. Both are queued with the motions. Priming is a PVT point
//                  at which the arm does not move.
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

// Assumed speed of 100 % joint motion: axes 1 to 3 of a TM5.
inline constexpr double kTmJointRadPerS = base::kPi;
inline constexpr int kTmStartPercent = 8;
inline constexpr double kTmFullVolts = 10.0;

plan::Program writeTmscript(const ProgramInput& input, const base::RunContext& ctx);

// Reads frames of one or more lines, statements without a frame, // remarks; PVTEnter, PVTPoint,
// PVTExit, PTP, Line and PLine, poses and joints as numbers, lists or variables; ChangeTCP and
// ChangeBase by their numbers, ChangeLoad, IO of the control box, ScriptExit and tmscriptWords().
// Anything else is a defect, and so are frames with a wrong length or checksum, speeds of Line that
// are not integers, and velocities that lead PVT off its line. A PTP slower than kTmMinPercent
// has no duration, as the rounded percentage does not determine it. `complete`: the program ends
// with ScriptExit, and the extruder's outputs are off after the last motion.
plan::ReadProgram readTmscript(const std::vector<plan::ProgramFile>& files,
                               const process::Tooling& tooling, const base::RunContext& ctx);
inline constexpr double kTmMinPercent = 12.0;
// Returns the other words that a program may contain, and where; all others are refused.
std::span<const KnownWord> tmscriptWords();
// Returns whether the statement must not stand between PVTEnter and PVTExit, where the arm moves.
bool needsRest(std::string_view word);
bool looksLikeTmscript(std::string_view text);

} // namespace voluta::program
