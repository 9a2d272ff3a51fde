// Plain G-code, three axes: X Y Z of the nozzle's tip, mm, E and F as of extended G-code, the
// nozzle along the plate's normal throughout. For flat jobs, on any printer with three axes.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// The directions are not looked at: dialect.h, requireUpright.
plan::Program writePlainGcode(const ProgramInput& input, const base::RunContext& ctx);

// Slicers' programs too, as far as they are motion and flow: filament a motion (M83), drawn back
// and pushed forward, speeds and single axes on lines of their own before the first bead, heat and
// fans. Their own end line stands for "; end".
plan::ReadProgram readPlainGcode(const std::vector<plan::ProgramFile>& files,
                                 const process::Process& process, const base::RunContext& ctx);
bool looksLikePlainGcode(std::string_view text);

} // namespace voluta::program
