// The sub-command "render": a picture of a job, with or without a display.
#pragma once

#include "cli/exit_code.h"

#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

// Adds the command; `run` is set when it is given.
void addRender(CLI::App& app, std::function<ExitCode()>& run);

} // namespace voluta::cli
