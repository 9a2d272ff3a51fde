#include "cli/batch_options.h"

#include "cli/batch_command.h"
#include "cli/option_texts.h"
#include "cli/run_interruptibly.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <utility>

namespace voluta::cli {

std::vector<std::string> takenPlanWords(std::vector<std::string>& words) {
  const auto dashes = std::ranges::find(words, "--");
  if (words.empty() || words.front() != "batch" || dashes == words.end())
    return {};
  std::vector<std::string> taken(dashes + 1, words.end());
  words.erase(dashes, words.end());
  return taken;
}

void addBatch(CLI::App& app, std::function<ExitCode()>& run, int threads, PlanWords plan) {
  auto options = std::make_shared<BatchOptions>();
  options->cores = threads;
  options->planWords = plan.given;
  CLI::App* batch = app.add_subcommand(
      "batch", "plan many parts, or a study of settings, as a Snakemake workflow; options of plan "
               "follow after --");
  CLI::Option* parts = batch->add_option(
      "PART", options->parts, "files of parts, or folders with such files (see: list parts)");
  CLI::Option* study =
      batch->add_option("--study", options->study,
                        "TABLE.csv: a job for each row and part; its columns are options of plan "
                        "(mode, cell), parameters (see: list parameters), name and part");
  batch
      ->add_option("-o", options->folder,
                   "folder for workflow, jobs, table.csv and table.json; the same command again "
                   "plans only the missing jobs and those whose part or options changed")
      ->required();
  batch->add_flag("--write-only", options->writeOnly, "write the workflow and do not run it");
  batch->add_flag("--table", options->tableOnly,
                  "only write the table of the jobs that have ended");
  batch->add_option("--cores", options->cores, "cores of this machine to use")
      ->check(CLI::Range(1, 1024));
  batch
      ->add_option("--threads", options->threads,
                   "threads of each job; default: the cores divided by the number of jobs")
      ->check(CLI::Range(1, 256));
  batch->add_option("--memory", options->memoryMb, "memory of a job on a cluster in MB")
      ->check(CLI::Range(100, 1000000));
  batch->add_option("--profile", options->profile,
                    "Snakemake profile of a cluster; slurm: the one that is written to the folder");
  batch->add_flag("--replace", options->replace, kReplaceHelp);
  batch->callback([options, parts, study, plan = std::move(plan), &run] {
    if (!options->tableOnly && parts->count() + study->count() == 0)
      throw CLI::RequiredError("PART or --study");
    std::vector<std::string> words = plan.given;
    words.insert(words.begin(), {"part.stl", "-o", "folder"});
    plan.require(words);
    options->planOptionNames = plan.optionNames();
    run = [options] { return batchCommand(*options); };
  });
}

} // namespace voluta::cli
