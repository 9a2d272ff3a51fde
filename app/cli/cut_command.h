// The sub-commands "cut" and "split": a part in two halves with a joint, or in its bodies.
#pragma once

#include "cli/exit_code.h"

#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

// Add the commands; `run` is set when one is given.
void addCut(CLI::App& app, std::function<ExitCode()>& run, int threads);
void addSplit(CLI::App& app, std::function<ExitCode()>& run, int threads);

} // namespace voluta::cli
