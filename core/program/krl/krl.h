// KRL for KUKA controllers (docs/programs.md, KRL).
//
// Written: print_NAME.src, whose DEF has the file's name, and an empty print_NAME.dat beside it; CR
// LF ends every line. mm, degrees, m/s, m/s2; A, B, C are Rz(A) Ry(B) Rx(C). Per point one motion:
//   Print, Linear  LIN {X,Y,Z,A,B,C}: pose of $TOOL in $BASE. The controller moves the TCP straight
//                  with $VEL.CP and turns it with $VEL.ORI1, $VEL.ORI2, whichever is slower; both
//                  stand before the motion where they change. Turn limits are high enough never to
//                  rule, but where the TCP hardly moves: there they give the time. $ACC.CP is the
//                  machine's most, as the plan's own speeds change gently. C_DIS with $APO.CDIS
//                  rounds the corner at its end by TcpMotions::blendMm, rounded down to steps of a
//                  tenth or so.
//   Joint          PTP {A1..A6}; PTP to a pose, without S and T, in a program for another maker's
//                  robot. $VEL_AXIS in percent of an axis' most, taken as kKrlPtpDegPerS.
// The first motion is a PTP with all axes (block coincidence), behind a HALT.
// Moving nozzle: $IPO_MODE=#BASE, $BASE the work frame, $TOOL the nozzle. Nozzle in the world:
// $IPO_MODE=#TCP, $BASE the nozzle and $TOOL the work frame on the flange; poses are the nozzle's
// on the part. External axes that move the part: $BASE=EK(MACHINE_DEF[2].ROOT, ..., frame) and E1,
// E2 and on in degrees in every target, whole turns added up; the frame is the work frame in that
// of what they move, z along the last axis (Cell::work_T_unit). Axes that carry the robot come
// first; AXES_UNDER_ROBOT says how many, $BASE is in $WORLD, and who sets up the controller lets
// $ROBROOT go with them. The extruder is on while $OUT[1]
// is, with a flow of $ANOUT[1] (0..1) x process.maxFlowMm3PerS. Assignments where the arm stands;
// between motions that do not stop they would halt it (they stop the advance run), so the flow is a
// TRIGGER at the next motion's beginning. A program of more than kKrlMotionsPerFile points gets
// files of about that many, which the first one calls in turn; its head tells when all are more
// than ProgramOptions::krlMemoryMb.
// An extruder that is an external axis has the first E that moves no part, in every target;
// EXTRUDER_AXIS says its number, a PTP of it alone feeds while the arm stands, and the module
// ZERO_EXTRUDER, a file of its own, is where it is set to 0.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/common/known_words.h"
#include "program/program_input.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr std::size_t kKrlMotionsPerFile = 2500;
// An axis' most, assumed: data sheets have 150 to 360.
inline constexpr double kKrlPtpDegPerS = 180.0;
// $ACC_MA.CP, assumed: who sets $ACC.CP no lower asks for nothing.
inline constexpr double kKrlMostMmPerS2 = 10000.0;

// Of an extruder that is an external axis (program/gcode/extruder_axis.h): the number of its E; the
// module that who stands by sets it to 0 in; and its most, assumed, which $VEL_EXTAX is percent of.
inline constexpr std::string_view kKrlExtruder = "EXTRUDER_AXIS", kKrlZero = "ZERO_EXTRUDER";
inline constexpr double kKrlExtruderMmPerS = 20.0;
// How many E carry the robot: E1 and on.
inline constexpr std::string_view kKrlUnderRobot = "AXES_UNDER_ROBOT";

// motionsPerFile; krlMemoryMb: what the controller has room for; the head of a longer program says
// so.
base::ParameterSpec krlMemoryMb();
std::vector<base::ParameterSpec> krlOptions();

plan::Program writeKrl(const ProgramInput& input, const base::RunContext& ctx);

// Understood: &-lines, DEF and DEFDAT, declarations (INT, REAL, BOOL, POS, E6POS, AXIS, E6AXIS,
// FRAME, SIGNAL), aggregates of numbers, sums and products, procedures without arguments called in
// turn over all files, PTP, LIN, SPTP, SLIN to literals or names with C_DIS and WITH, partial
// targets, $OUT, $ANOUT, TRIGGER at a motion's beginning, WAIT SEC, BAS and krlWords(). Everything
// else is a defect; so are outputs behind CONTINUE, which run ahead of the arm. An output between
// motions halts the arm: the blend before it is none. Motions under EK are UnitPose, under #TCP
// WorkPose, else FlangePose, with the E that carry the robot. Where turning takes longer than the
// way, the motion's time is that. `complete`: every procedure ended, every file was come to, the
// extruder's outputs are off behind the last motion.
plan::ReadProgram readKrl(const std::vector<plan::ProgramFile>& files,
                          const process::Process& process, const base::RunContext& ctx);
// What else may stand in a program, and where: statements, and variables that may be assigned.
std::span<const KnownWord> krlWords();
bool looksLikeKrl(std::string_view text);
bool mayBeMissingInKrl(const std::vector<std::string>& lines, std::size_t i); // Dialect
// The files of the procedures that a text calls and does not define.
std::vector<std::string> filesOfKrl(std::string_view text);

} // namespace voluta::program
