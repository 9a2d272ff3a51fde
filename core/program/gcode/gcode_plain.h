// Plain G-code for three axes: X Y Z of the nozzle's tip [mm], E and F as in extended G-code, the
// nozzle always along the plate's normal. For flat jobs, on any printer with three axes.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Ignores the directions; see requireUpright in dialect.h.
plan::Program writePlainGcode(const ProgramInput& input, const base::RunContext& ctx);

// Also reads slicers' programs, as far as they are motion and flow: filament per motion (M83),
// retraction, speeds and single axes on separate lines before the first bead, heat and fans. Their
// own end line counts as "; end".
plan::ReadProgram readPlainGcode(const std::vector<plan::ProgramFile>& files,
                                 const process::Tooling& tooling, const base::RunContext& ctx);
bool looksLikePlainGcode(std::string_view text);

} // namespace voluta::program
