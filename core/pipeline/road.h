// The complete pipeline (docs/design.md, The road): the only place that knows every stage.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"
#include "project/job.h"
#include "project/job_stage.h"
#include "project/report.h"

#include <filesystem>
#include <string>

namespace voluta::pipeline {

// Plans a part up to request.until. Stages whose key is in the cache are taken from it. The
// report's timings are those of each stage's original run; `total` is the time of this call. Mode
// auto searches again, unless the plan ends with Load or Decompose and the choices name the way
// that an earlier search chose. Throws Error{Usage} for unknown names and values out of range,
// Error{UnreadableFile, UnusableInput} for the part. Anything that cannot be printed, reached or
// verified is in job.report.findings.
// Example:
//   pipeline::PlanRequest request;
//   request.item().part = "sample:vase";
//   request.choices.item().mode = "flat";
//   request.until = project::Stage::Layers;
//   pipeline::PlanResult result = pipeline::planPart(request, ctx);
//   pipeline::writeOutputs(result, save, ctx);
PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx,
                    StageCache* cache = nullptr, const PlanObservers& observers = {});

// Returns the keys of all stages for this request, regardless of its `until`. A displayed result
// with another key is out of date. Reads the cell and process files; takes about a millisecond.
// Precondition: request.loaded. Throws Error{Usage} as planPart does.
project::StageKeys stageKeys(const PlanRequest& request);

// Returns a reopened job as planPart returned it, without the programs. Throws Error{Usage,
// UnreadableFile, UnusableInput} if its cell or process no longer exists.
PlanResult resultOf(project::Job job);

// Returns whether the report has no blocking finding, which includes a failed replay.
bool nothingBlocks(const project::Report& report);

struct VerifyResult {
  std::string format;
  project::ReplayReport replay;
  plan::Findings findings;
};
// Replays a program from disk against the plan in a job file. All files of the program are read,
// whichever of them is named. If the program's head names another job or cell, that finding comes
// first. Throws Error{UnreadableFile}, Error{UnusableInput} if no motion of the program is
// understood, Error{Usage}.
VerifyResult verifyProgram(const std::filesystem::path& program, const std::filesystem::path& job,
                           const base::RunContext& ctx);
// Same for a job in memory. Precondition: it has a part, a tool-plan and a trajectory.
VerifyResult verifyProgram(const std::filesystem::path& program, const project::Job& job,
                           const base::RunContext& ctx);

} // namespace voluta::pipeline
