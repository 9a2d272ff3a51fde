// A recorded run beside the plan of a job (record/run_comparison.h).
#pragma once

#include "base/run_context.h"
#include "project/job.h"
#include "record/run_comparison.h"

#include <filesystem>
#include <string>

namespace voluta::pipeline {

struct ComparedRun {
  std::string format; // of the record
  record::RunComparison comparison;
};

// Compares a record from disk with the motion planned in a job file; of a resumed print with its
// rest. Throws Error{UnreadableFile, UnusableInput} for a job without a motion, a record that
// cannot be read, or one that does not come near the plan; Error{Usage}; Cancelled.
ComparedRun compareRun(const std::filesystem::path& job, const std::filesystem::path& record,
                       const record::RunTolerances& tolerances, const base::RunContext& ctx);
// Same for a job in memory. Precondition: it has a trajectory.
ComparedRun compareRun(const project::Job& job, const std::filesystem::path& record,
                       const record::RunTolerances& tolerances, const base::RunContext& ctx);

} // namespace voluta::pipeline
