// Amounts of filament over time in a file beside a robot's program, for an extruder that another
// computer drives (Castelli 2020, 3.2.2: who sends the robot its targets sends the extruder its
// own). The clock starts anew each time the program's digital output goes on, so that no travel has
// to be as long as planned.
//
//   # E stream beside print_box
//   # filament diameter 1.75 mm
//   on 3                  the output goes on where 3 motions are done
//   4 0.050000 0.02110    0.05 s later motion 4 is done, and 0.0211 mm of filament are out
//   off 4
//   end
//
// A line that stays at the motion of its `on` is for an arm that stands, the prime.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>

namespace voluta::program {

// What a program's head says of it; the file's name follows.
inline constexpr std::string_view kStreamNote = "amounts of filament in file ";
std::string streamName(const ProgramInput& input);

// With times and amounts as program/common/tcp_motions.h has them. Throws Cancelled.
plan::ProgramFile streamFile(const ProgramInput& input, const base::RunContext& ctx);

bool looksLikeStream(std::string_view text);
// The name of the stream that a program's head tells of; empty: none.
std::string streamOf(std::string_view program);

// Gives each motion and pause of a program, whose output is on meanwhile, what the stream has for
// it; `file`: of the stream, for its defects. What is not in both is one, and so is time or
// filament that runs back.
void applyStream(std::string_view stream, std::size_t file, plan::ReadProgram& program);

} // namespace voluta::program
