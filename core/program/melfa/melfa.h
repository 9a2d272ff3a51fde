// MELFA-BASIC V for Mitsubishi controllers (docs/programs.md; CR750 series instruction manual,
// chapter 4).
//
// Written programs have numbered steps with one statement each and CR LF line ends; units are mm
// and degrees. Positions are constants in the motion's own line, (x,y,z,a,b,c)(flags): poses of the
// TCP in the robot's base with R = Rz(c) Ry(b) Rx(a), products of frames already multiplied. One
// motion per point:
//   Print, Linear  Mvs; with a stationary nozzle EMvs 1: the arm holds the work, and moves and
//   speeds
//                  are those of the nozzle on it (Ex-T control; work coordinates 1 are the
//                  nozzle's).
//                  Preceded by Spd where the speed changes and by Cnt 1,r,r where the blend changes
//                  (constant within a factor of two, never more than TcpMotions::blendMm); Cnt 0
//                  follows a motion at whose end the arm stops.
//   Joint          Mov to J1, set in the step before; Mov to a position in a program for another
//                  maker's robot. JOvrd in percent of kMelfaJointRadPerS. The first point is
//                  reached
//                  at kMelfaStartPercent of it, after Hlt, which waits for the operator. The
//                  extruder is on while output kMelfaExtruder is on. The 16 outputs from kMelfaFlow
//                  on hold the flow as a number, M_Outw; kMelfaFullFlow means
//                  the full flow. Where the arm does not stop, the number changes together
//                  with the motion that begins there (Wth). A program of more than
//                  kMelfaMotionsPerFile motions is divided into programs that the first one calls
//                  in turn (CallP).
#pragma once

#include "base/run_context.h"
#include "base/units.h"
#include "plan/program.h"
#include "plan/stated_facts.h"
#include "program/common/extruder_outputs.h"
#include "program/common/known_words.h"
#include "program/program_input.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr int kMelfaExtruder = 10, kMelfaFlow = 16;
// Returns the number of an output or input of ProgramEmitter; those of marks come before the
// extruder's, as the flow begins where they would be: a channel (plan/marks.h) before the other.
constexpr int melfaSignal(int signal) {
  const int mark = signal - kMarkOutput;
  return mark < 0 ? kMelfaExtruder + signal : kMelfaExtruder - 2 - mark / 2 * 2 + mark % 2;
}
// The inverse of melfaSignal().
constexpr int melfaOutputOf(double number) {
  const int output = static_cast<int>(number) - kMelfaExtruder;
  const int channel = (-output - 1) / 2; // of a mark
  return output >= 0 ? output : kMarkOutput + 2 * channel + output + 2 * (channel + 1);
}
inline constexpr double kMelfaFullFlow = 10000.0;
// Assumed speed of 100 % joint motion: programs do not state their arm's speeds.
inline constexpr double kMelfaJointRadPerS = base::kPi;
inline constexpr double kMelfaStartPercent = 8.0;
// Acceleration along a line with which an RV-2F moves 25-300-25 mm in 0.3 s.
inline constexpr double kMelfaMmPerS2 = 10000.0;
inline constexpr std::size_t kMelfaMaxCharacters = 127, kMelfaMaxSteps = 32767;
inline constexpr std::size_t kMelfaMotionsPerFile = 6500; // With at most five steps each

std::vector<base::ParameterSpec> melfaOptions(); // Returns the parameter motionsPerFile

// The controller's default for targets without flags (CR750, 4.4.12; different on some machines).
inline constexpr plan::ArmPosture kMelfaUsualPosture{.structure = 7, .turns = 0};
// Returns the flags of a target: structure (4 right, 2 above, 1 not flipped), and whole turns, 4
// bits per axis. `joints`: of the arm and its external axes; those of a foreign arm are unknown.
plan::ArmPosture melfaPosture(const robot::Cell& cell, bool foreign, const double* joints);

plan::Program writeMelfa(const ProgramInput& input, const base::RunContext& ctx);

// Reads steps with or without numbers, statements that share a line, labels and remarks; Tool, Base
// P_NBase, P_WkCord, Mov, Mvs, EMvs with a separation and Wth, Spd, Ovrd, JOvrd, Cnt, outputs, Dly;
// variables of numbers, positions and joints with sums, products and components (values set before,
// in or after the program); GoSub, CallP of available files, and melfaWords(). Letters of either
// case. Anything else is a defect, and so are numbers that do not ascend, steps that are too long
// or too many, and a different base. Without distances, Cnt 1 blends over the stopping distance and
// is reported as OpenRounding. `complete`: every program ended with End, with the extruder's
// outputs off after its last motion.
plan::ReadProgram readMelfa(const std::vector<plan::ProgramFile>& files,
                            const process::Tooling& tooling, const base::RunContext& ctx);
// Returns the other words that a program may contain, and where; all others are refused.
std::span<const KnownWord> melfaWords();
bool looksLikeMelfa(std::string_view text);
bool mayBeMissingInMelfa(const std::vector<std::string>& lines, std::size_t i); // See Dialect
// Returns the names of the programs that this one calls.
std::vector<std::string> filesOfMelfa(std::string_view text);

} // namespace voluta::program
