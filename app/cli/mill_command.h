// The sub-command "mill": a part milled out of a block.
#pragma once

#include "cli/exit_code.h"
#include "milling/mill_replay.h"

#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

// Adds the command; `run` is set when it is given.
void addMill(CLI::App& app, std::function<ExitCode()>& run, int threads);

// Prints why a milled part is not done, and returns the code.
ExitCode millExitCode(const milling::MillVerdict& verdict);

} // namespace voluta::cli
