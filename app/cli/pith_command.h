// The sub-command "pith": the pith of a part as a body that carries the part.
#pragma once

#include "cli/exit_code.h"

#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

// Adds the command; `run` is set when it is given.
void addPith(CLI::App& app, std::function<ExitCode()>& run, int threads);

} // namespace voluta::cli
