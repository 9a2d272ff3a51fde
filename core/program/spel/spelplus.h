// SPEL+ for Epson controllers (docs/programs.md, SPEL+; Epson RC+, SPEL+ Language Reference).
//
// Written: one Function per file, CR LF. mm, degrees; U, V, W are Rz(U) Ry(V) Rx(W). One motion per
// point:
//   Print, Linear  Move XY(x,y,z,u,v,w): pose of the tool in Base (Local 0), straight at SpeedS
//   [mm/s],
//                  which alone determines its duration. Where the TCP hardly moves, ROT makes the
//                  rotation rule instead, at SpeedR. CP: the next motion accelerates while this one
//                  decelerates, so the corner is rounded from v^2 / (2 AccelS) before it to the
//                  same
//                  distance after it. AccelS is kSpelplusMmPerS2, or more where the blend would
//                  otherwise exceed TcpMotions::blendMm.
//   Joint          Go AglToPls(j1,...); Go XY(...) in a program for another maker's robot. Speed in
//                  percent of an axis' maximum, assumed to be kSpelplusPtpDegPerS. The first motion
//                  follows a Pause and runs under Power Low, in which the controller moves slowly
//                  regardless of settings; Power High follows it, without which SpeedS has no
//                  effect. Moving nozzle: TLSet 1 is the nozzle. Fixed nozzle: TLSet 1 is the work
//                  frame on the flange, ECPSet 1 the nozzle, and motions have ECP: straight then
//                  means the nozzle's path on the part (an option of the controller). AutoLJM keeps
//                  the arm's posture. A four-axis arm has XY(x,y,z,u), with u the sum of the
//                  rotations of its joints and the tool, also beyond half a turn, z of flange and
//                  tool both up, and the side of its elbow, /R or /L (joint 2 above 0 or not);
//                  joint 3 in AglToPls is in mm. External axes do not move the print surface: no
//                  rod. The extruder is on while output 1 is on, with the flow on analogue output
//                  1, 10 V for the full flow. A statement after a motion with CP runs when
//                  that motion begins to decelerate.
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

// Assumed maximum of an axis: data sheets have 120 to 550.
inline constexpr double kSpelplusPtpDegPerS = 180.0;
// AccelS that all of the arms support; maximum that some support.
inline constexpr double kSpelplusMmPerS2 = 5000.0, kSpelplusMaxMmPerS2 = 25000.0;

std::vector<base::ParameterSpec> spelplusOptions(); // motionsPerFile

plan::Program writeSpelplus(const ProgramInput& input, const base::RunContext& ctx);

// Supported: functions without arguments, called in turn over all files; declaration and use of
// numbers (Real, Double, Integer, Long) and points (P1 = XY(...), P1 = P2 +X(5)), sums and
// products, TLSet, Tool, Local, ECPSet, ECP, Go and Move with CP, ROT, ECP, LJM, Speed, Accel,
// SpeedS, AccelS, SpeedR, AccelR, Power, CP On, On, Off, AIO_Out, Wait and spelplusWords(); several
// statements in one line separated by semicolons. Everything else is a defect, and so is a straight
// motion under Power Low. `complete`: every function ended, every file was reached, the extruder's
// outputs are off after the last motion.
plan::ReadProgram readSpelplus(const std::vector<plan::ProgramFile>& files,
                               const process::Tooling& tooling, const base::RunContext& ctx);
// Other allowed words, and where they are allowed.
std::span<const KnownWord> spelplusWords();
bool looksLikeSpelplus(std::string_view text);
bool mayBeMissingInSpelplus(const std::vector<std::string>& lines, std::size_t i); // Dialect
// Returns the files of the functions that a text calls and does not define.
std::vector<std::string> filesOfSpelplus(std::string_view text);

} // namespace voluta::program
