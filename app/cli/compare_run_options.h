// The options of sub-command compare-run.
#pragma once

#include "cli/exit_code.h"

#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

// Adds the sub-command. If the user chooses it, `chosen` is called with its work while the options
// are parsed. `threads`: the default of --threads.
void addCompareRun(CLI::App& app, int threads,
                   const std::function<void(std::function<ExitCode()>)>& chosen);

} // namespace voluta::cli
