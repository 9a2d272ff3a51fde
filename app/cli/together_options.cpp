#include "cli/together_options.h"

#include "cli/option_texts.h"

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace voluta::cli {

void addTogether(CLI::App& app, std::function<ExitCode()>& run, int threads) {
  struct Values {
    TogetherOptions options;
    std::vector<std::string> places;
    std::vector<std::size_t> beads, lines;
  };
  static const std::map<std::string, ProgressStyle> kStyles{
      {"bar", ProgressStyle::Bar}, {"json", ProgressStyle::Json}, {"none", ProgressStyle::None}};
  auto values = std::make_shared<Values>();
  values->options.threads = threads;
  CLI::App* together =
      app.add_subcommand("together", "plan jobs whose machines work in one cell, or verify them");
  CLI::Option* jobs = together->add_option("JOBS", values->options.jobs,
                                           "job.voluta of each machine, or station.voluta of all");
  CLI::Option* places =
      together
          ->add_option("--place", values->places,
                       "X,Y,Z,ROTATION for each machine but the first: its base in "
                       "the frame of the first one's, in mm, and its rotation "
                       "about z in degrees")
          ->allow_extra_args(false);
  CLI::Option* clearance =
      together
          ->add_option("--clearance", values->options.clearanceMm,
                       "minimum distance of moving bodies of two machines in mm (default: 10, or "
                       "that of the station)")
          ->check(CLI::Range(0.0, 500.0));
  CLI::Option* insideBeads =
      together
          ->add_option("--pause-in-beads", values->options.pauseInBeadsS,
                       "lets a machine wait inside a bead, with the extruder off, where it has had "
                       "no other place to wait for so many seconds")
          ->check(CLI::Range(0.1, 1e6));
  CLI::Option* beads = together
                           ->add_option("--bead", values->beads,
                                        "of a stopped station: the bead with which each machine "
                                        "goes on, numbered from 1, as in 12,8")
                           ->delimiter(',');
  CLI::Option* lines = together
                           ->add_option("--at", values->lines,
                                        "of a stopped station: the line of each machine's program "
                                        "with which it goes on, as in 340,220")
                           ->delimiter(',')
                           ->excludes(beads);
  CLI::Option* folder =
      together->add_option("-o", values->options.folder, "folder for all jobs and together.json");
  together->add_flag("--replace", values->options.replace, kReplaceHelp);
  together
      ->add_option("--verify", values->options.verified,
                   "folder written before: reads its programs and replays them in one time")
      ->excludes(jobs)
      ->excludes(beads)
      ->excludes(lines)
      ->excludes(places)
      ->excludes(clearance)
      ->excludes(insideBeads)
      ->excludes(folder);
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
      if (!values->options.verified.empty())
        return verifyTogetherCommand(values->options);
      for (const std::string& place : values->places)
        values->options.places.push_back(pipeline::parsedMachinePlace(place));
      for (const std::size_t bead : values->beads)
        values->options.resumed.push_back({.bead = bead});
      for (const std::size_t line : values->lines)
        values->options.resumed.push_back({.line = line});
      return togetherCommand(values->options);
    };
  });
}

} // namespace voluta::cli
