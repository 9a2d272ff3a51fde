// The sub-command "mill": a part milled out of a block.
#pragma once

#include "cli/exit_code.h"

#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

// Adds the command; `run` is set when it is given.
void addMill(CLI::App& app, std::function<ExitCode()>& run, int threads);

} // namespace voluta::cli
