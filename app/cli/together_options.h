// The sub-command `together`.
#pragma once

#include "cli/exit_code.h"
#include "cli/progress.h"
#include "pipeline/station_resume.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace CLI {
class App;
}

namespace voluta::cli {

struct TogetherOptions {
  std::vector<std::filesystem::path> jobs;          // or the project of a station
  std::vector<Eigen::Isometry3d> places;            // of the second job and the following ones
  std::optional<double> clearanceMm, pauseInBeadsS; // default: those of the station
  std::vector<pipeline::ResumePlace> resumed;       // per machine of the station; empty: all of it
  std::filesystem::path folder;
  bool replace = false;           // files of the folder that are not of such a job
  std::filesystem::path verified; // a folder that was written before: verified instead
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
// Plans jobs whose machines work in one cell. Throws Error{Usage} if their numbers do not agree.
ExitCode togetherCommand(const TogetherOptions& options);
// Verifies the programs in `options.verified`.
ExitCode verifyTogetherCommand(const TogetherOptions& options);

// Adds the sub-command; sets `run` if it is chosen.
void addTogether(CLI::App& app, std::function<ExitCode()>& run, int threads);

} // namespace voluta::cli
