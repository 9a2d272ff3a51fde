// Amounts of filament over time in a file beside a robot's program, for an extruder driven by
// another computer (Castelli 2020, 3.2.2: the computer that sends the robot its targets also
// controls the extruder). The clock restarts each time the program's digital output goes on, so
// that the durations of travels need not match the plan.
//
//   # E stream beside print_box
//   # filament diameter 1.75 mm
//   on 3                  the output goes on after 3 motions
//   4 0.050000 0.02110    0.05 s later motion 4 is done, and 0.0211 mm of filament were pushed
//   off 4
//   end
//
// A line with the same motion as its `on` is for an arm at rest, i.e. the prime.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>

namespace voluta::program {

// Note in the program's head, followed by the file's name.
inline constexpr std::string_view kStreamNote = "amounts of filament in file ";
std::string streamName(const ProgramInput& input);

// Writes the stream, with times and amounts as in program/common/tcp_motions.h. Throws Cancelled.
plan::ProgramFile streamFile(const ProgramInput& input, const base::RunContext& ctx);

bool looksLikeStream(std::string_view text);
// Returns the name of the stream in a program's head; empty if there is none.
std::string streamOf(std::string_view program);

// Sets the extrusion of each motion and pause with the output on from the stream; `file`: index of
// the stream, for its defects. Entries without a counterpart in either are defects, and so are
// decreasing times or amounts.
void applyStream(std::string_view stream, std::size_t file, plan::ReadProgram& program);

} // namespace voluta::program
