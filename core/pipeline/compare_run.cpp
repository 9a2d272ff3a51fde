#include "pipeline/compare_run.h"

#include "base/error.h"
#include "base/files.h"
#include "base/staged_folder.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {
double fullFlowOf(const process::Tooling& tooling) {
  double maximum = 0.0;
  for (const process::Tool& tool : tooling.tools())
    maximum = std::max(maximum, tool.process.maxFlowMm3PerS);
  return maximum;
}
} // namespace

ComparedRun compareRun(const std::filesystem::path& job, const std::filesystem::path& record,
                       const record::RunTolerances& tolerances, const base::RunContext& ctx) {
  base::finishStaged(std::filesystem::absolute(job).parent_path());
  const project::Job planned = project::readJob(job, allParameters());
  if (!planned.trajectory)
    throw base::Error(base::ErrorCode::UnusableInput, "the job has no motion to compare with"_text,
                      job.string(), "plan it without --until"_text);
  return compareRun(planned, record, tolerances, ctx);
}

ComparedRun compareRun(const project::Job& job, const std::filesystem::path& record,
                       const record::RunTolerances& tolerances, const base::RunContext& ctx) {
  base::require(job.trajectory != nullptr, "compareRun: a job with its motion");
  const process::Tooling tooling = resolve(job.choices).tooling;
  const robot::Cell cell =
      robot::loadCell(job.choices.cell, tooling.first().process, project::platformOf(job));
  const record::RecordedRun run =
      record::readRecord(base::readFile(record), record.string(), {cell, fullFlowOf(tooling)});
  const record::PlannedRun planned =
      record::plannedRun(*job.trajectory, cell, job.resumedAt, ctx.quiet());
  return {run.format, record::compareRun(run, planned, tolerances, ctx)};
}

} // namespace voluta::pipeline
