// The sub-command `together`.
#pragma once

#include "cli/exit_code.h"
#include "cli/progress.h"
#include "pipeline/together.h"

#include <array>
#include <filesystem>
#include <functional>

namespace CLI {
class App;
}

namespace voluta::cli {

struct TogetherOptions {
  std::array<std::filesystem::path, 2> jobs;
  pipeline::TogetherRequest request; // without the jobs
  std::filesystem::path folder;
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
// Plans two jobs whose machines work in one cell.
ExitCode togetherCommand(const TogetherOptions& options);

// Adds the sub-command; sets `run` if it is chosen.
void addTogether(CLI::App& app, std::function<ExitCode()>& run, int threads);

} // namespace voluta::cli
