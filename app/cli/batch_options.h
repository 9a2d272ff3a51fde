// The sub-command "batch": plans of many parts, or of a study of settings, as a Snakemake workflow.
#pragma once

#include "cli/exit_code.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace voluta::cli {

// The options of plan, as batch hands them on.
struct PlanWords {
  std::vector<std::string> given; // After "--"
  // Throws CLI::ParseError if plan does not take these words.
  std::function<void(std::vector<std::string>)> require;
  // Returns the options of plan that take a value, without dashes.
  std::function<std::vector<std::string>()> optionNames;
};

// Removes "--" and the words behind it from a command line of batch, and returns these words.
// Leaves the words of other commands.
std::vector<std::string> takenPlanWords(std::vector<std::string>& words);

// Adds the command; `run` is set when it is given.
void addBatch(CLI::App& app, std::function<ExitCode()>& run, int threads, PlanWords plan);

} // namespace voluta::cli
