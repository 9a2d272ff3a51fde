// G-code for a machine whose table tilts and turns (B and C, tilting_table.h):
// G1 X-4.3830 Y-10.0858 Z46.1879 B-9.09498 C-126.50727 E4.32400 F1200
//
// X Y Z: the machine's axes, mm, zero where the nozzle touches the plate's centre with the table at
// 0 0. B C: degrees; as the part turns right-handed about y and z, or the other way round where the
// head says so (tables that count by the tool, ISO 841). E: length of filament, absolute (M82). The
// machine knows nothing of the part: all axes go evenly from target to target. So every motion says
// its time, G93 with F = 1 / minutes, and is G1 (G0 would take no heed of F); and where the nozzle
// would leave its straight line on the part by more than kSagMm, it comes in pieces. Before the
// first motion: home, up to where the table may turn beneath, and the table.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// As blends (kBlendToleranceMm): about what tables repeat to, and well within what a replay lets
// pass.
inline constexpr double kSagMm = 0.02;
// Of the table, as the head tells the reader.
inline constexpr std::string_view kTableNote = "plate over the tilt axis, mm: ";
inline constexpr std::string_view kReversedNote = "B and C count the tool's turn, not the part's";

// The plate's centre as seen from the tilt axis, mm (tilting_table.h), and whether the table's
// angles count the tool's turn ("tool") instead of the part's.
base::ParameterSpec tableXMm();
base::ParameterSpec tableZMm();
base::ParameterSpec tableSense();
// Beyond so many turns to a side C goes back by whole turns in a travel: the table ("wind", the
// default), and then it never passes them; or its count, G92 C, without a motion, for tables that
// turn without end ("count"). 0: as few turns as suit, or one.
base::ParameterSpec tableTurns();
base::ParameterSpec tableUnwind();
std::vector<base::ParameterSpec> tableGcodeOptions();

// Throws Error{Usage}: a bead turns the table further than it may and cannot be wound back within.
plan::Program writeTableGcode(const ProgramInput& input, const base::RunContext& ctx);

// Targets become points and directions on the part, with the way between them. Under G94 F is the
// speed along X Y Z, or degrees a minute where none of them moves; G0 needs G94. In a program with
// our head (kTableNote) every motion wants G93. G92 C may set its count to another number of whole
// turns. Z up, C by whole turns, one a motion, and Z back is a table that is wound back
// (plan::ProgramMotion::aside). The table must not turn before Z is known, nor X or Y be sent
// before B and C are.
plan::ReadProgram readTableGcode(const std::vector<plan::ProgramFile>& files,
                                 const process::Process& process, const base::RunContext& ctx);
bool looksLikeTableGcode(std::string_view text);

} // namespace voluta::program
