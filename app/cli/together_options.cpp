#include "cli/together_options.h"

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>

namespace voluta::cli {

void addTogether(CLI::App& app, std::function<ExitCode()>& run, int threads) {
  struct Values {
    TogetherOptions options;
    std::string place;
  };
  static const std::map<std::string, ProgressStyle> kStyles{
      {"bar", ProgressStyle::Bar}, {"json", ProgressStyle::Json}, {"none", ProgressStyle::None}};
  auto values = std::make_shared<Values>();
  values->options.threads = threads;
  pipeline::TogetherRequest& request = values->options.request;
  CLI::App* together =
      app.add_subcommand("together", "plan two jobs whose machines work in one cell");
  together->add_option("FIRST", values->options.jobs[0], "job.voluta of the first machine")
      ->required();
  together->add_option("SECOND", values->options.jobs[1], "job.voluta of the second machine")
      ->required();
  together
      ->add_option("--place", values->place,
                   "X,Y,Z,TURN: base of the second machine in the frame of the first one's, in mm, "
                   "and its rotation about z in degrees")
      ->required();
  together
      ->add_option("--clearance", request.options.distances.clearanceMm,
                   "least distance of moving bodies of both machines in mm")
      ->check(CLI::Range(0.0, 500.0));
  together->add_option("-o", values->options.folder, "folder for both jobs and together.json")
      ->required();
  together->add_option("--threads", values->options.threads, "threads to use")
      ->check(CLI::Range(1, 256));
  together
      ->add_option_function<std::string>(
          "--progress",
          [values](const std::string& style) { values->options.progress = kStyles.at(style); },
          "how progress is shown")
      ->check(CLI::IsMember({"bar", "json", "none"}));
  together->callback([values, &run] {
    run = [values] {
      values->options.request.first_T_second = pipeline::parsedMachinePlace(values->place);
      return togetherCommand(values->options);
    };
  });
}

} // namespace voluta::cli
