// G-code for a machine whose table tilts and turns (B and C, tilting_table.h): G1 X-4.3830
// Y-10.0858 Z46.1879 B-9.09498 C-126.50727 E4.32400 F1200
//
// X Y Z: the machine's axes [mm], zero where the nozzle touches the plate's centre with the table
// at 0 0. B C: degrees, right-handed rotations of the part about y and z, or the opposite if the
// head says so (tables that count the tool's rotation, ISO 841). E: length of filament, absolute
// (M82). The machine does not know the part: all axes move linearly from target to target. So every
// motion states its time, G93 with F = 1 / minutes, and is a G1 (G0 would ignore F). Where the
// nozzle would leave its straight line on the part by more than kSagMm, the motion is split into
// pieces. Before the first motion: home, then up to where the table is free to turn, then the
// table, then above the start.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Like blends (kBlendToleranceMm): about the repeatability of tables, and well within the tolerance
// of a replay.
inline constexpr double kSagMm = 0.02;
// Notes in the head that describe the table to the reader.
inline constexpr std::string_view kTableNote = "plate over the tilt axis, mm: ";
inline constexpr std::string_view kReversedNote = "B and C count the tool's turn, not the part's";

// The plate's centre relative to the tilt axis [mm] (tilting_table.h), and whether the table's
// angles are the tool's rotation ("tool") or the part's.
base::ParameterSpec tableXMm();
base::ParameterSpec tableZMm();
base::ParameterSpec tableSense();
// Beyond this number of turns to either side C is reset by whole turns during a travel: either the
// table is wound back ("wind", the default) and never exceeds the limit, or its count is changed
// without a motion (G92 C, "count"), for tables that turn endlessly. 0: the smallest suitable
// number of turns, or one.
base::ParameterSpec tableTurns();
base::ParameterSpec tableUnwind();
std::vector<base::ParameterSpec> tableGcodeOptions();

// Returns whether the cell's external axes are such a table (table_of_cell.h). Its position then
// comes from the cell, not from the options, and B and C from the motion of its axes.
bool movesTable(const robot::Cell& cell);

// Throws Error{Usage} if a bead turns the table beyond its limit, so that winding back cannot keep
// within it.
plan::Program writeTableGcode(const ProgramInput& input, const base::RunContext& ctx);

// Returns targets as points and directions on the part, with the path between them. Under G94 F is
// the speed along X Y Z, or degrees per minute if none of them moves; G0 requires G94. In a program
// with Voluta's head (kTableNote) every motion requires G93. G92 C may change the count by whole
// turns. Z up, C by whole turns, one per motion, and Z back is read as winding back
// (plan::ProgramMotion::detour). The table must not turn before Z is known, and X and Y must not
// move before B and C are. The motions before all five are known, in a program with that head those
// before G93, are approaches (plan::ProgramApproach); the motion that follows must not turn the
// table.
plan::ReadProgram readTableGcode(const std::vector<plan::ProgramFile>& files,
                                 const process::Tooling& tooling, const base::RunContext& ctx);
bool looksLikeTableGcode(std::string_view text);

} // namespace voluta::program
