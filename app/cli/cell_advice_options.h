// The command line of `cell place` and `cell advise`.
#pragma once

#include "cli/exit_code.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace voluta::cli {

// Adds both commands to `cell`. `chosen` is called with the command's work when it was parsed.
void addCellAdvice(CLI::App& cell, int threads,
                   const std::function<void(std::function<ExitCode()>)>& chosen);

} // namespace voluta::cli
