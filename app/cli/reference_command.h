// The sub-command "reference": all commands and options as a man page, or as a completion of bash.
// Both are made from the tables that parse the command line.
#pragma once

#include "cli/exit_code.h"

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace voluta::cli {

// Adds the command; `run` is set when it is given. `app` must outlive the run.
void addReference(CLI::App& app, std::function<ExitCode()>& run);

// Returns the page in the language of man(7). `date`: of its foot.
std::string manPage(const CLI::App& app, const std::string& date);
std::string bashCompletion(const CLI::App& app);

} // namespace voluta::cli
