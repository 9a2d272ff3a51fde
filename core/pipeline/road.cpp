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

// Throws Error{Usage} if the job has several tools, the choices of an item are invalid, or several
// items leave their way of building to a search, which plans a part alone.
void checkItems(const project::Choices& choices) {
  if (choices.tools.size() > 1)
    throw base::Error(base::ErrorCode::Usage, "jobs with several tools cannot be planned yet"_text,
                      {}, "choose one process"_text);
  for (std::size_t i = 0; i < choices.items.size(); ++i) {
    checkChoices(project::onlyItem(choices, i));
    if (choices.items.size() > 1 && choices.item(i).automatic)
      throw base::Error(base::ErrorCode::Usage, "mode auto plans one part at a time"_text, {},
                        "choose a way of building for each part"_text);
  }
}

project::StageKeys keysOfItem(const project::LoadedPart& loaded, const project::Choices& choices) {
  const bool given = takesGivenPaths(loaded, parameterValues(choices));
  const project::Choices own =
      resolved(given ? choicesForGivenPaths(choices) : wayOrFirst(choices));
  const base::ParameterValues values = parameterValues(own);
  return keysOf(loaded, own, values, chosenTooling(own, values));
}

} // namespace

PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                    const PlanObservers& observers) {
  checkItems(request.choices);
  PlanRequest given = request;
  // While the user edits, the part is placed and decomposed in the way that the last search chose.
  const bool searches = request.until > project::Stage::Decompose || !namesWay(request.choices);
  if (request.choices.item().automatic && !takesGivenPathsOf(given, ctx) && searches)
    return planAutomatically(given, ctx, cache, observers);
  return planChosenWay(given, ctx, cache, observers);
}

project::StageKeys stageKeys(const PlanRequest& request) {
  checkItems(request.choices);
  std::vector<project::StageKeys> keys;
  for (std::size_t i = 0; i < request.items.size(); ++i) {
    base::require(request.item(i).loaded != nullptr, "stageKeys: parts that are loaded");
    keys.push_back(keysOfItem(*request.item(i).loaded, project::onlyItem(request.choices, i)));
  }
  return joinedKeys(keys, request.choices.printOrder);
}

PlanResult resultOf(project::Job job) {
  checkItems(job.choices);
  PlanResult result;
  result.items.resize(job.items.size());
  const base::ParameterValues values = parameterValues(job.choices);
  result.tooling = chosenTooling(job.choices, values);
  const process::Process& process = result.tooling->first().process;
  if (job.item().platform.known())
    result.cell = std::make_shared<robot::Cell>(
        robot::loadCell(job.choices.cell, process, job.item().platform));
  result.debug = values.boolean("output.debug");
  result.keepRefused = values.boolean("output.refused");
  result.proofs = values.boolean("output.proof");
  result.buildFile = values.boolean("output.build3mf");
  if (job.item().part) {
    if (!job.item().placement)
      job.item().placement = placementByHandOrMode(
          *job.item().loaded->mesh, job.item().scale * unitMm(*job.item().loaded, job.choices),
          {job.choices, values, process});
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
