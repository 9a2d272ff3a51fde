#include "pipeline/road.h"

#include "base/error.h"
#include "pipeline/automatic.h"
#include "pipeline/choices.h"
#include "pipeline/given_paths.h"
#include "pipeline/stage_keys.h"
#include "pipeline/stage_runner.h"
#include "pipeline/way_search.h"
#include "plan/finding_kinds.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {

// Loads the part if that is not done. If the part brings its own tool-paths, replaces the request's
// choices by those for given paths and returns true.
bool takesGivenPathsOf(PlanRequest& request, const base::RunContext& ctx) {
  if (!request.item().loaded)
    request.item().loaded =
        project::loadPart(request.item().part, request.choices.item().repair, ctx.sub(0, 0.02));
  if (!takesGivenPaths(*request.item().loaded, parameterValues(request.choices)))
    return false;
  request.choices = choicesForGivenPaths(request.choices);
  return true;
}

} // namespace

PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                    const PlanObservers& observers) {
  checkChoices(request.choices);
  PlanRequest given = request;
  // While the user edits, the part is placed and decomposed in the way that the last search chose.
  const bool searches = request.until > project::Stage::Decompose || !namesWay(request.choices);
  if (request.choices.item().automatic && !takesGivenPathsOf(given, ctx) && searches)
    return planAutomatically(given, ctx, cache, observers);
  return planChosenWay(given, ctx, cache, observers);
}

project::StageKeys stageKeys(const PlanRequest& request) {
  base::require(request.item().loaded != nullptr, "stageKeys: a part that is loaded");
  checkChoices(request.choices);
  const bool given = takesGivenPaths(*request.item().loaded, parameterValues(request.choices));
  const project::Choices choices =
      resolved(given ? choicesForGivenPaths(request.choices) : wayOrFirst(request.choices));
  const base::ParameterValues values = parameterValues(choices);
  return keysOf(*request.item().loaded, choices, values, chosenProcess(choices, values));
}

PlanResult resultOf(project::Job job) {
  checkChoices(job.choices);
  PlanResult result;
  const base::ParameterValues values = parameterValues(job.choices);
  result.process = std::make_shared<process::Process>(chosenProcess(job.choices, values));
  if (job.item().platform.known())
    result.cell = std::make_shared<robot::Cell>(
        robot::loadCell(job.choices.cell, *result.process, job.item().platform));
  result.debug = values.boolean("output.debug");
  result.keepRefused = values.boolean("output.refused");
  result.proofs = values.boolean("output.proof");
  result.buildFile = values.boolean("output.build3mf");
  if (job.item().part) {
    if (!job.item().placement)
      job.item().placement = placementByHandOrMode(
          *job.item().loaded->mesh, job.item().scale * unitMm(*job.item().loaded, job.choices),
          {job.choices, values, *result.process});
    result.item().placed = loadStageOf(job);
  }
  result.job = std::move(job);
  return result;
}

bool nothingBlocks(const project::Report& report) {
  return std::none_of(report.findings.begin(), report.findings.end(),
                      [](const plan::Finding& f) { return f.blocking; });
}

} // namespace voluta::pipeline
