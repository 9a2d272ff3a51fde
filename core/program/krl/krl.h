// Writer and reader of KRL for KUKA controllers (docs/programs.md, KRL).
//
// The writer produces print_NAME.src, whose DEF has the file's name, and an empty print_NAME.dat
// beside it; lines end with CR LF. Units are mm, degrees, m/s, m/s2; A, B, C are Rz(A) Ry(B) Rx(C).
// One motion per point:
//   Print, Linear  LIN {X,Y,Z,A,B,C}: pose of $TOOL in $BASE. The controller moves the TCP straight
//                  with $VEL.CP and turns it with $VEL.ORI1, $VEL.ORI2, whichever is slower; both
//                  are set before the motion at which they change. The turn limits are so high that
//                  they only take effect where the TCP hardly moves: there they determine the time.
//                  $ACC.CP is the machine's maximum, as the plan's own speeds change gently. C_DIS
//                  with $APO.CDIS rounds the corner at the motion's end by TcpMotions::blendMm,
//                  rounded down to steps of about a tenth.
//   Joint          PTP {A1..A6}; in a program for another maker's robot PTP to a pose without S and
//                  T. $VEL_AXIS is in percent of an axis' maximum, assumed to be kKrlPtpDegPerS.
//
// The first motion, after a HALT, is a PTP with all axes (block coincidence). Moving nozzle:
// $IPO_MODE=#BASE, $BASE the work frame, $TOOL the nozzle. Nozzle fixed in the world:
// $IPO_MODE=#TCP, $BASE the nozzle and $TOOL the work frame on the flange; poses are the nozzle's
// on the part. External axes that move the part: $BASE=EK(MACHINE_DEF[2].ROOT, ..., frame) and E1,
// E2, ... in degrees in every target, with whole turns accumulated; the frame is the work frame in
// the frame that these axes move, z along the last axis (Cell::work_T_unit). Axes that carry the
// robot come first; AXES_UNDER_ROBOT is their number, $BASE is in $WORLD, and the person who sets
// up the controller makes $ROBROOT follow them.
//
// The extruder is on while $OUT[1] is, with a flow of $ANOUT[1] (0..1) x the full flow.
// Where the arm is at rest, outputs are assigned directly. Between motions that do not stop, an
// assignment would halt the arm (it stops the advance run); there the flow is set by a TRIGGER at
// the start of the next motion. A program of more than kKrlMotionsPerFile points is divided into
// files of about that size, which the first file calls in turn; its head contains a note if all
// files together exceed ProgramOptions::krlMemoryMb.
//
// An extruder that is an external axis is the first E that does not move the part, and is in every
// target; EXTRUDER_AXIS is its number, a PTP of it alone feeds material while the arm is at rest,
// and the module ZERO_EXTRUDER, a separate file, sets it to 0.
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
// Assumed maximum speed of an axis: data sheets have 150 to 360.
inline constexpr double kKrlPtpDegPerS = 180.0;
// Assumed $ACC_MA.CP: as long as $ACC.CP is not set lower, no acceleration is stated.
inline constexpr double kKrlMaxMmPerS2 = 10000.0;

// For an extruder that is an external axis (program/gcode/extruder_axis.h): the number of its E,
// the module in which the operator sets it to 0, and its assumed maximum speed, of which $VEL_EXTAX
// is a percentage.
inline constexpr std::string_view kKrlExtruder = "EXTRUDER_AXIS", kKrlZero = "ZERO_EXTRUDER";
inline constexpr double kKrlExtruderMmPerS = 20.0;
// The number of external axes that carry the robot: E1, E2, ...
inline constexpr std::string_view kKrlUnderRobot = "AXES_UNDER_ROBOT";

// Options motionsPerFile and krlMemoryMb: the controller's program memory. A longer program
// contains a note in its head.
base::ParameterSpec krlMemoryMb();
std::vector<base::ParameterSpec> krlOptions();

plan::Program writeKrl(const ProgramInput& input, const base::RunContext& ctx);

// Reads: &-lines, DEF and DEFDAT, declarations (INT, REAL, BOOL, POS, E6POS, AXIS, E6AXIS, FRAME,
// SIGNAL), aggregates of numbers, sums and products, procedures without arguments (called in turn,
// over all files), PTP, LIN, SPTP, SLIN to literals or names with C_DIS and WITH, partial targets,
// $OUT, $ANOUT, TRIGGER at the start of a motion, WAIT SEC, BAS and krlWords(). Everything else is
// a defect, and so are outputs after CONTINUE, which run ahead of the arm. An output between
// motions halts the arm, so that the blend before it is 0. Motions under EK are UnitPose, under
// #TCP WorkPose, else FlangePose, with the external axes that carry the robot. If the rotation
// takes longer than the path, it determines the motion's time. `complete`: every procedure ended,
// every file was reached, and the extruder's outputs are off after the last motion.
plan::ReadProgram readKrl(const std::vector<plan::ProgramFile>& files,
                          const process::Tooling& tooling, const base::RunContext& ctx);
// Returns the other known words and where they may occur: statements, and variables that may be
// assigned.
std::span<const KnownWord> krlWords();
bool looksLikeKrl(std::string_view text);
bool mayBeMissingInKrl(const std::vector<std::string>& lines, std::size_t i); // See Dialect.
// Returns the files of the procedures that a text calls but does not define.
std::vector<std::string> filesOfKrl(std::string_view text);

} // namespace voluta::program
