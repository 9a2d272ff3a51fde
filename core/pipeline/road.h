// The whole road (docs/design.md, The road): the one place that knows every stage.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"
#include "project/job.h"
#include "project/report.h"
#include "project/stage.h"

#include <filesystem>
#include <string>

namespace voluta::pipeline {

// Stages whose key is in the cache are taken from there. The report's timings are what each stage
// took when it was made, `total` what this plan took.
// Mode auto chooses anew, but for a plan that ends with Load or Decompose and whose choices name
// the way of an earlier one.
// Throws Error{Usage}: unknown names, values out of range; Error{UnreadableFile, UnusableInput}:
// the part. Whatever cannot be printed, reached or verified is in job.report.findings.
// Example:
//   pipeline::PlanRequest request;
//   request.part = "sample:vase";
//   request.choices.mode = "flat";
//   request.until = project::Stage::Layers;
//   pipeline::PlanResult result = pipeline::planPart(request, ctx);
//   pipeline::writeOutputs(result, save, ctx);
PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx,
                    StageCache* cache = nullptr, const PlanObservers& observers = {});

// The keys that the stages of this request have, whatever its `until`. What is shown and has
// another key is out of date. Reads the cell's and the process's file; takes about a millisecond.
// Precondition: request.loaded. Throws Error{Usage} as planPart does.
project::StageKeys stageKeys(const PlanRequest& request);

// A reopened job as planPart left it, but for the programs. Throws Error{Usage, UnreadableFile,
// UnusableInput} where its cell or process is not there any more.
PlanResult resultOf(project::Job job);

// No blocking finding, and the replay passed where the road came that far.
bool nothingBlocks(const project::Report& report);

struct VerifyResult {
  std::string format;
  project::ReplayReport replay;
  plan::Findings findings;
};
// Replays a program from disk, with all its files whichever is named, against the plan in a job
// file. A program whose head names another job or cell is told first. Throws Error{UnreadableFile,
// UnusableInput (no motion is understood in it), Usage}.
VerifyResult verifyProgram(const std::filesystem::path& program, const std::filesystem::path& job,
                           const base::RunContext& ctx);
// Against a job at hand. Precondition: it has part, tool-plan and trajectory.
VerifyResult verifyProgram(const std::filesystem::path& program, const project::Job& job,
                           const base::RunContext& ctx);

} // namespace voluta::pipeline
