// The whole road (docs/design.md, The road): the one place that knows every stage.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "pipeline/stage_cache.h"
#include "pipeline/stages.h"
#include "plan/program.h"
#include "project/job.h"
#include "project/report.h"
#include "project/stage.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct PlanRequest {
  std::string part;                                  // path of a mesh, or "sample:NAME"
  std::shared_ptr<const project::LoadedPart> loaded; // used instead of `part` when set
  project::Choices choices;
  project::Stage until = project::Stage::Replay; // the plan ends after it
};

// Copies are cheap: whatever is large is shared.
struct PlanResult {
  project::Job job;                               // choices, results and report
  std::shared_ptr<const modes::LoadStage> placed; // null before Load is done
  std::shared_ptr<const process::Process> process;
  std::shared_ptr<const robot::Cell> cell; // with the job's platform; null before Decompose is done
  std::vector<std::shared_ptr<const CheckedProgram>> checked; // one a format, refused ones too
  bool debug = false;                                         // --set output.debug=true
  bool keepRefused = false;                                   // --set output.refused=true
  bool proofs = false;                                        // --set output.proof=true
  bool buildFile = false;                                     // --set output.build3mf=true
};

// Called on the running thread as soon as a stage is done, taken from the cache or not, with all
// that is there so far.
using StageObserver = std::function<void(project::Stage, const PlanResult&)>;

// Called on the running thread with what a decomposition that is being made has come to: its ranks,
// then its field as rounds improve it; and with the plan, which has its Load stage by then.
using PreviewObserver =
    std::function<void(std::shared_ptr<const curved::Decomposition>, const PlanResult&)>;

// Which way of building mode auto is planning.
struct WayInTurn {
  base::Message name; // "flat layers with supports"
  std::size_t number = 1, count = 1;
  bool isLast() const { return number == count; }
};
// Called on the running thread before each way.
using WayObserver = std::function<void(const WayInTurn&)>;

// Each may be empty.
struct PlanObservers {
  StageObserver onStage = {};
  PreviewObserver onPreview = {};
  WayObserver onWay = {};
};

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
// Replays a program from disk against the plan in a job file. A program whose head names another
// job or cell is told first. Throws Error{UnreadableFile, UnusableInput (no motion is understood in
// it), Usage}.
VerifyResult verifyProgram(const std::filesystem::path& program, const std::filesystem::path& job,
                           const base::RunContext& ctx);
// Against a job at hand. Precondition: it has part, tool-plan and trajectory.
VerifyResult verifyProgram(const std::filesystem::path& program, const project::Job& job,
                           const base::RunContext& ctx);

} // namespace voluta::pipeline
