// One function a sub-command: typed options in, exit code out. Results go to stdout, progress and
// the one line about what went wrong to stderr.
#pragma once

#include "cli/exit_code.h"
#include "cli/progress.h"
#include "pipeline/road.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::cli {

struct PlanOptions {
  pipeline::PlanRequest request;
  std::filesystem::path folder;
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
ExitCode planCommand(const PlanOptions& options);

struct VerifyOptions {
  std::filesystem::path program, job;
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
ExitCode verifyCommand(const VerifyOptions& options);

struct InspectOptions {
  std::string part;
  bool json = false;
};
ExitCode inspectCommand(const InspectOptions& options);

struct RobotOptions {
  std::string id;
  std::string forward, inverse; // comma separated; one of them
};
ExitCode robotCommand(const RobotOptions& options);

struct ListOptions {
  std::string what;
  bool json = false;
};
ExitCode listCommand(const ListOptions& options);

} // namespace voluta::cli
