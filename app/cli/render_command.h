// The sub-commands "render" and "film": a picture of a job, and the robot that prints it.
#pragma once

#include "cli/exit_code.h"

#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

// Each adds its command; `run` is set when it is given.
void addRender(CLI::App& app, std::function<ExitCode()>& run);
void addFilm(CLI::App& app, std::function<ExitCode()>& run);

} // namespace voluta::cli
