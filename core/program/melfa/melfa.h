// MELFA-BASIC V for Mitsubishi controllers (docs/programs.md; CR750 series instruction manual,
// chapter 4).
//
// Written: numbered steps, one statement each, CR LF behind each; mm, degrees. Positions stand as
// constants in the motion's own line, (x,y,z,a,b,c)(flags), poses of the TCP in the robot's base
// with R = Rz(c) Ry(b) Rx(a), products of frames made here. Per point one motion:
//   Print, Linear  Mvs; with the nozzle in the world EMvs 1: the arm holds the work, moves and
//                  speeds are those of the nozzle on it (Ex-T control; work coordinates 1 are the
//                  nozzle's). Spd before it where the speed is another, Cnt 1,r,r where the blend
//                  is (held within a factor of two, never more than TcpMotions::blendMm), Cnt 0
//                  behind a motion at whose end the arm stands.
//   Joint          Mov to J1, set in the step before; Mov to a position in a program for another
//                  maker's robot. JOvrd per cent of kMelfaJointRadPerS. The first point is reached
//                  at kMelfaStartPercent of it, behind Hlt, which waits for the operator.
// The extruder is on while output kMelfaExtruder is, with a flow of the 16 outputs from kMelfaFlow
// on as a number, M_Outw, kMelfaFullFlow for process.maxFlowMm3PerS. Where the arm does not stand
// the number changes with the motion that begins there (Wth). A program of more motions than
// kMelfaMotionsPerFile is cut into programs that a first one calls in turn (CallP).
#pragma once

#include "base/run_context.h"
#include "base/units.h"
#include "plan/program.h"
#include "plan/stated_facts.h"
#include "program/common/known_words.h"
#include "program/program_input.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr int kMelfaExtruder = 10, kMelfaFlow = 16;
inline constexpr double kMelfaFullFlow = 10000.0;
// What 100 % of a joint motion is taken for: a program does not say its arm's speeds.
inline constexpr double kMelfaJointRadPerS = base::kPi;
inline constexpr double kMelfaStartPercent = 8.0;
// Along a line, what an RV-2F gets along 25-300-25 mm in 0.3 s with.
inline constexpr double kMelfaMmPerS2 = 10000.0;
inline constexpr std::size_t kMelfaMostCharacters = 127, kMelfaMostSteps = 32767;
inline constexpr std::size_t kMelfaMotionsPerFile = 6500; // of five steps at most

std::vector<base::ParameterSpec> melfaOptions(); // motionsPerFile

// What the controller takes where a target has no flags (CR750, 4.4.12; on some machines others).
inline constexpr plan::ArmPosture kMelfaUsualPosture{.structure = 7, .turns = 0};
// The flags of a target: structure (4 right, 2 above, 1 not flipped), and whole turns, 4 bits an
// axis. `joints`: of the arm and what is behind it; of a foreign arm nothing is known of them.
plan::ArmPosture melfaPosture(const robot::Cell& cell, bool foreign, const double* joints);

plan::Program writeMelfa(const ProgramInput& input, const base::RunContext& ctx);

// Understood: steps with or without numbers, statements that share a line, labels, remarks; Tool,
// Base P_NBase, P_WkCord, Mov, Mvs, EMvs with a separation and Wth, Spd, Ovrd, JOvrd, Cnt, outputs,
// Dly, variables of numbers, positions and joints with sums, products and parts (their values
// before, within or behind the program), GoSub, CallP of files that are there, and melfaWords();
// letters of either case. Everything else is a defect, and so are numbers that do not ascend, steps
// too long or too many, and another base. Without distances Cnt 1 blends as far as it takes to
// stop, and is stated as OpenRounding. `complete`: every program ended with End, the extruder's
// outputs off behind its last motion.
plan::ReadProgram readMelfa(const std::vector<plan::ProgramFile>& files,
                            const process::Process& process, const base::RunContext& ctx);
// What else may stand in a program, and where; everything else is refused.
std::span<const KnownWord> melfaWords();
bool looksLikeMelfa(std::string_view text);
bool mayBeMissingInMelfa(const std::vector<std::string>& lines, std::size_t i); // Dialect
// The programs that one calls.
std::vector<std::string> filesOfMelfa(std::string_view text);

} // namespace voluta::program
