// Joint table (CSV): the unchanged trajectory, for programs and controllers that play tables.
//
// A comment "# ...", a header line, one row per point, and "# end" as the last line. Columns:
// time_s, j1_deg ... (j3_mm for a sliding joint), extruded_mm3 (cumulative), waypoint (of the tool
// plan, -1: none), move (print, linear: straight in the work frame; joint: linear in joints). The
// duration of a motion is the difference between the times of its row and the previous one.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

namespace voluta::program {

plan::Program writeJointTable(const ProgramInput& input, const base::RunContext& ctx);
// `complete`: the line "# end" is the last one.
plan::ReadProgram readJointTable(const std::vector<plan::ProgramFile>& files,
                                 const process::Tooling& tooling, const base::RunContext& ctx);
bool looksLikeJointTable(std::string_view text);

} // namespace voluta::program
