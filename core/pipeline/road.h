// The whole road (DESIGN §3): the one place that knows every stage.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "curved/decomposition.h"
#include "layers/layer_stack.h"
#include "pipeline/job.h"
#include "pipeline/report.h"
#include "plan/program.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

// The stages in order; a plan ends after the one asked for.
enum class Until { Load, Decompose, Layers, Toolpath, Motion, Replay };
// Throws Error{Usage} for an unknown name, naming the nearest.
Until untilOf(const std::string& name);

// Every module's parameters in one table.
base::ParameterTable allParameters();
// Checks "key=value" texts against the table and keeps them in choices.parameters.
// Throws Error{Usage}.
void setParameters(Choices& choices, const std::vector<std::string>& assignments);

struct PlanRequest {
  std::string part; // path of a mesh, or "sample:NAME"
  Choices choices;
  Until until = Until::Replay;
};

struct PlanResult {
  Job job;
  Report report;
  std::vector<plan::Program> programs; // those that may be handed over; where asked for, also
                                       // refused ones, their files named refused-...
  // What the stages made, for --set output.debug=true; null where not reached.
  bool debug = false;
  std::shared_ptr<const curved::Decomposition> decomposition;
  std::shared_ptr<const layers::LayerStack> layers;
};

// Throws Error{Usage}: unknown names, values out of range; Error{UnreadableFile, UnusableInput}:
// the part. Whatever cannot be printed, reached or verified is in report.findings.
PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx);

// No blocking finding, and the replay passed where the road came that far.
bool nothingBlocks(const Report& report);

struct VerifyResult {
  std::string format;
  ReplayReport replay;
  plan::Findings findings;
};
// Replays a program from disk against the plan in a job file. Throws Error{UnreadableFile,
// UnusableInput, Usage}.
VerifyResult verifyProgram(const std::filesystem::path& program, const std::filesystem::path& job,
                           const base::RunContext& ctx);

} // namespace voluta::pipeline
