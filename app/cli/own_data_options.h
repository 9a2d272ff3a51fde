// The command line of `material`, `process` and of files of `cell`: the user's own files.
#pragma once

#include "cli/exit_code.h"

#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

// Add the commands; `into` is set when one is given.
void addMaterial(CLI::App& app, std::function<ExitCode()>& into);
void addProcess(CLI::App& app, std::function<ExitCode()>& into);
// `cell`: the command that they belong to.
void addCellFiles(CLI::App& cell, std::function<ExitCode()>& into);

} // namespace voluta::cli
