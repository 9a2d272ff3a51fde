// SPEL+ for Epson controllers (docs/programs.md, SPEL+; Epson RC+, SPEL+ Language Reference).
//
// Written: one Function a file, CR LF. mm, degrees; U, V, W are Rz(U) Ry(V) Rx(W). Per point one
// motion:
//   Print, Linear  Move XY(x,y,z,u,v,w): pose of the tool in Base (Local 0), straight at SpeedS,
//                  mm/s, which alone says how long it takes; where the TCP hardly moves, ROT makes
//                  the turn rule instead, at SpeedR. CP: the next motion speeds up while this one
//                  slows down, so the corner is rounded from v^2 / (2 AccelS) before it to as much
//                  behind it. AccelS is kSpelplusMmPerS2, more where the corner would else leave
//                  TcpMotions::blendMm.
//   Joint          Go AglToPls(j1,...); Go XY(...) in a program for another maker's robot. Speed in
//                  percent of an axis' most, taken as kSpelplusPtpDegPerS.
// The first motion is behind a Pause and under Power Low, in which the controller goes slowly
// whatever is set; Power High follows it, without which SpeedS has no effect.
// Moving nozzle: TLSet 1 is the nozzle. Nozzle in the world: TLSet 1 is the work frame on the
// flange, ECPSet 1 the nozzle, and motions have ECP: straight is then the nozzle's way on the part
// (an option of the controller). AutoLJM keeps the arm's posture. A four-axis arm has XY(x,y,z,u),
// u the sum of what its joints turn and the tool, beyond half a turn too, z of flange and tool both
// up, and the side of its elbow, /R or /L (joint 2 above 0 or not); joint 3 in AglToPls is in mm.
// External axes move nothing that is printed on: no rod. The extruder is on while output 1 is, with
// a flow of analogue output 1, 10 V for process.maxFlowMm3PerS. A statement behind a motion with CP
// runs when that begins to slow down.
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

// An axis' most, assumed: data sheets have 120 to 550.
inline constexpr double kSpelplusPtpDegPerS = 180.0;
// AccelS that any of the arms takes; the most that some take.
inline constexpr double kSpelplusMmPerS2 = 5000.0, kSpelplusMostMmPerS2 = 25000.0;

std::vector<base::ParameterSpec> spelplusOptions(); // motionsPerFile

plan::Program writeSpelplus(const ProgramInput& input, const base::RunContext& ctx);

// Understood: functions without arguments called in turn over all files, numbers (Real, Double,
// Integer, Long) and points (P1 = XY(...), P1 = P2 +X(5)) declared and named, sums and products,
// TLSet, Tool, Local, ECPSet, ECP, Go and Move with CP, ROT, ECP, LJM, Speed, Accel, SpeedS,
// AccelS, SpeedR, AccelR, Power, CP On, On, Off, AIO_Out, Wait and spelplusWords(); statements in
// one line between semicolons. Everything else is a defect, and so is a straight motion under Power
// Low. `complete`: every function ended, every file was come to, the extruder's outputs are off
// behind the last motion.
plan::ReadProgram readSpelplus(const std::vector<plan::ProgramFile>& files,
                               const process::Process& process, const base::RunContext& ctx);
// What else may stand in a program, and where.
std::span<const KnownWord> spelplusWords();
bool looksLikeSpelplus(std::string_view text);
bool mayBeMissingInSpelplus(const std::vector<std::string>& lines, std::size_t i); // Dialect
// The files of the functions that a text calls and does not define.
std::vector<std::string> filesOfSpelplus(std::string_view text);

} // namespace voluta::program
