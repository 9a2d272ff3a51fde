#include "cli/compare_run_options.h"

#include "cli/commands.h"
#include "cli/new_file.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace voluta::cli {

void addCompareRun(CLI::App& app, int threads,
                   const std::function<void(std::function<ExitCode()>)>& chosen) {
  struct Values {
    CompareRunOptions options;
    double speedPercent = 1.0, flowPercent = 1.0;
    std::string progress = "bar";
  };
  const auto values = std::make_shared<Values>();
  CompareRunOptions& options = values->options;
  options.threads = threads;
  CLI::App* command = app.add_subcommand("compare-run", "compare a recorded run with its plan");
  command->add_option("JOB", options.job, "job.voluta that was run")->required();
  command
      ->add_option("RECORD", options.record,
                   "table that the controller recorded: RTDE, MELFA, or joints over time")
      ->required();
  command
      ->add_option("--path-tolerance", options.tolerances.pathMm,
                   "path errors up to this are not listed [mm]")
      ->check(CLI::PositiveNumber);
  command->add_option("--speed-tolerance", values->speedPercent, "likewise for speeds [%]")
      ->check(CLI::PositiveNumber);
  command->add_option("--flow-tolerance", values->flowPercent, "likewise for flow [%]")
      ->check(CLI::PositiveNumber);
  command->add_option("--places", options.places, "number of places listed of each kind");
  command->add_option("-o", options.curve, "FILE.csv for the errors along the record");
  addReplaceFile(*command, options.replace);
  command->add_option("--threads", options.threads, "threads to use")->check(CLI::Range(1, 256));
  command->add_option("--progress", values->progress, "how progress is shown")
      ->check(CLI::IsMember({"bar", "json", "none"}));
  command->callback([values, chosen] {
    chosen([values] {
      values->options.progress = values->progress == "json"   ? ProgressStyle::Json
                                 : values->progress == "none" ? ProgressStyle::None
                                                              : ProgressStyle::Bar;
      values->options.tolerances.speed = 0.01 * values->speedPercent;
      values->options.tolerances.flow = 0.01 * values->flowPercent;
      return compareRunCommand(values->options);
    });
  });
}

} // namespace voluta::cli
