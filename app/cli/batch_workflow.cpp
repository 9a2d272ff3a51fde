#include "cli/batch_workflow.h"

#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

namespace voluta::cli {

namespace fs = std::filesystem;

namespace {
using Json = nlohmann::ordered_json;

constexpr std::string_view kFirstLine = "# Written by voluta-cli batch";

// A job that ended with a result, though not the wanted one, is done: its row says so. Other ends
// (a signal, an error of the program) leave it to the next run.
constexpr std::string_view kSnakefile = R"(: one job for each part, and a table of their results.
# This runs or resumes it:  snakemake --cores all --keep-going --rerun-incomplete
import shlex

configfile: "config.json"

JOBS = config["jobs"]
PROGRAM = shlex.quote(config["program"])
START = shlex.quote(config["startFolder"])

wildcard_constraints:
    job="[-.A-Za-z0-9_]+"

localrules: table

rule table:
    input:
        expand("results/{job}.json", job=list(JOBS))
    output:
        "table.csv", "table.json", "compare.html"
    shell:
        "{PROGRAM} batch --table -o ."

rule plan:
    input:
        lambda wildcards: JOBS[wildcards.job]["files"]
    output:
        "results/{job}.json"
    params:
        words=lambda wildcards: " ".join(shlex.quote(word) for word in JOBS[wildcards.job]["words"])
    threads: config["threads"]
    resources:
        mem_mb=config["memoryMb"]
    shell:
        """
        mkdir -p jobs logs
        out="$PWD/jobs/{wildcards.job}" log="$PWD/logs/{wildcards.job}" code=0
        rm -rf "$out"
        (cd {START} && {PROGRAM} plan {params.words} -o "$out" --threads {threads} --progress none) \
            > "$log.txt" 2> "$log.err" || code=$?
        case $code in
            0|2|3|4) echo '{{"exitCode": '$code'}}' > {output} ;;
            *) exit $code ;;
        esac
        """
)";

constexpr std::string_view kSlurmProfile =
    R"(# Profile of Snakemake for Slurm, written once by voluta-cli batch. Add --partition or --account to sbatch here.
cluster: "mkdir -p logs && sbatch --parsable --job-name=voluta-{wildcards} --cpus-per-task={threads} --mem={resources.mem_mb} --output=logs/slurm-%j.txt"
cluster-status: "slurm-status.sh"
cluster-cancel: "scancel"
jobs: 1000
max-status-checks-per-second: 10
latency-wait: 60
)";

// Snakemake waits for ever for a job that was killed, unless it is told.
constexpr std::string_view kSlurmStatus = R"(#!/bin/sh
# Prints the state of a Slurm job as Snakemake asks for it: success, running or failed.
answer=$(scontrol --oneliner show job "$1" 2>&1)
case $answer in
  *JobState=COMPLETED*) echo success ;;
  *JobState=PENDING* | *JobState=RUNNING* | *JobState=COMPLETING* | *JobState=CONFIGURING* | *JobState=SUSPENDED* | *JobState=REQUEUED*) echo running ;;
  *JobState=* | *"Invalid job id"*) echo failed ;;
  *) echo running ;; # the controller does not answer
esac
)";

Json configOf(const BatchOptions& options, const std::vector<BatchJob>& jobs) {
  const int count = static_cast<int>(jobs.size());
  Json config{
      {"program", fs::read_symlink("/proc/self/exe").string()},
      {"startFolder", fs::current_path().string()},
      {"threads", options.threads > 0 ? options.threads : std::max(1, options.cores / count)},
      {"memoryMb", options.memoryMb},
      {"jobs", Json::object()}};
  for (const BatchJob& job : jobs) {
    Json row{{"files", Json::array()}, {"words", Json::array({job.part})}};
    if (fs::exists(job.part))
      row["files"].push_back(job.part);
    for (const std::string& word : job.words)
      row["words"].push_back(word);
    row["settings"] = Json::object();
    for (const auto& [key, value] : job.settings)
      row["settings"][key] = value;
    config["jobs"][job.name] = std::move(row);
  }
  return config;
}

void requireOwnFolder(const BatchOptions& options) {
  std::error_code none;
  const fs::path snakefile = options.folder / "Snakefile";
  if (options.replace || !fs::exists(options.folder) || fs::is_empty(options.folder, none) ||
      base::beginningOf(snakefile, kFirstLine.size()) == kFirstLine)
    return;
  throw base::Error(base::ErrorCode::CannotWrite, "the folder holds no batch, but other files"_text,
                    options.folder.string(), "choose another folder, or give --replace"_text);
}

} // namespace

void writeWorkflow(const BatchOptions& options, const std::vector<BatchJob>& jobs) {
  requireOwnFolder(options);
  const fs::path profile = options.folder / "slurm";
  std::error_code status;
  fs::create_directories(profile, status);
  base::writeFile(options.folder / "Snakefile", std::string(kFirstLine) + std::string(kSnakefile));
  base::writeFile(options.folder / kBatchConfig, configOf(options, jobs).dump(2) + "\n");
  if (fs::exists(profile / "config.yaml"))
    return;
  base::writeFile(profile / "config.yaml", kSlurmProfile);
  base::writeFile(profile / "slurm-status.sh", kSlurmStatus);
  fs::permissions(profile / "slurm-status.sh", fs::perms(0755), status);
}

} // namespace voluta::cli
