// The files of a Snakemake workflow (https://snakemake.readthedocs.io): Snakefile, config.json and
// a profile for Slurm.
#pragma once

#include "cli/batch_jobs.h"

#include <filesystem>
#include <vector>

namespace voluta::cli {

inline constexpr const char* kBatchConfig = "config.json";

// Writes them to options.folder, which is made if it does not exist. A profile that is there stays,
// as it may have been edited. Throws Error{CannotWrite} if the folder contains other files and
// options.replace is not set.
void writeWorkflow(const BatchOptions& options, const std::vector<BatchJob>& jobs);

} // namespace voluta::cli
