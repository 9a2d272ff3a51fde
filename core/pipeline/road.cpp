#include "pipeline/road.h"

#include "base/error.h"
#include "layers/tool_assignment.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/given_paths.h"
#include "pipeline/items/named_errors.h"
#include "pipeline/path_parameters.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_keys.h"
#include "pipeline/stage_options.h"
#include "pipeline/stage_runner.h"
#include "pipeline/stages.h"
#include "pipeline/way_search.h"
#include "project/loaded_part.h"
#include "robot/cell.h"

#include <algorithm>
#include <tuple>

namespace voluta::pipeline {

namespace {

// Loads the only part if that is not done. If it brings its own tool-paths, replaces the request's
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

// Throws Error{Usage} if the mode of one of several items prints on no plate.
void requirePlate(const project::ItemChoices& item) {
  const bool onPlate = item.automatic || !modes::findMode(item.mode).aroundRod;
  if (!onPlate || item.platform.isBody())
    throw base::Error(base::ErrorCode::Usage,
                      "a part around a rod or on a body is printed alone"_text, {},
                      "remove the other parts, or choose a way of building on a plate"_text);
}

// Throws Error{Usage} if the tool-paths of one of several items are printed on a ground of their
// own.
void requireOnPlate(const PlanRequest& one) {
  if (pathShape(parameterValues(one.choices)).ground.shape != sliced::GroundShape::Plate)
    throw base::Error(base::ErrorCode::Usage, "a part on a ground of its own is printed alone"_text,
                      one.item().loaded->name,
                      "remove the other parts, or give `pathsOn=plate`"_text);
}

// Throws Error{Usage} if the job has too many items or tools, or invalid choices of an item.
void checkItems(const project::Choices& choices) {
  constexpr std::size_t kMaxItems = 255; // replay::BeadPiece::item
  if (choices.tools.size() > layers::kMaxTools)
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("{tools} tools are too many for a job"_text, choices.tools.size()), {},
        base::message("give up to {most}"_text, layers::kMaxTools));
  if (choices.items.size() > kMaxItems)
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("{parts} parts are too many for a job"_text, choices.items.size()), {},
        base::message("print up to {most} parts"_text, kMaxItems));
  for (std::size_t i = 0; i < choices.items.size(); ++i) {
    checkChoices(project::onlyItem(choices, i));
    if (choices.items.size() > 1)
      requirePlate(choices.item(i));
  }
}

// Returns whether mode auto searches for the way of building. While the user edits, a part is
// placed and decomposed in the way that the last search chose.
bool searches(const PlanRequest& request) {
  return request.until > project::Stage::Decompose || !namesStrategy(request.choices);
}

PlanRequest onlyItem(const PlanRequest& request, std::size_t i) {
  PlanRequest one;
  one.items = {request.item(i)};
  one.choices = project::onlyItem(request.choices, i);
  one.until = request.until;
  return one;
}

// Returns whether the choices of two items differ at most in their place on the plate.
bool areAlike(const project::ItemChoices& a, const project::ItemChoices& b) {
  const auto all = [](const project::ItemChoices& c) {
    return std::tie(c.automatic, c.platformStays, c.automaticStrategy, c.mode, c.growth, c.platform,
                    c.scale, c.units, c.placement.liftMm, c.repair, c.parameters, c.regions);
  };
  return all(a) == all(b) && a.placement.rotation.coeffs() == b.placement.rotation.coeffs();
}

// Plans several parts. Each part whose way of building is left to mode auto is planned alone first;
// copies take the way that was found for the first of them.
PlanResult planSeveral(PlanRequest request, const base::RunContext& ctx, StageCache* cache,
                       const PlanObservers& observers) {
  const double count = static_cast<double>(request.items.size());
  constexpr double kSearchShare = 0.5;
  const project::Choices given = request.choices;
  std::vector<std::vector<project::TriedReport>> tried(request.items.size());
  for (std::size_t i = 0; i < request.items.size(); ++i) {
    const double at = static_cast<double>(i);
    const base::RunContext own =
        ctx.sub(kSearchShare * at / count, kSearchShare * (at + 1.0) / count);
    PlanRequest one = onlyItem(request, i);
    const bool hasPaths = takesGivenPathsOf(one, own);
    request.item(i).loaded = one.item().loaded;
    if (hasPaths) {
      requireOnPlate(one);
      request.choices.item(i) = one.choices.item();
      continue;
    }
    if (!request.choices.item(i).automatic || !searches(one))
      continue;
    std::size_t same = 0;
    while (request.item(same).loaded->hash != request.item(i).loaded->hash ||
           !areAlike(given.item(same), given.item(i)))
      ++same;
    if (same < i) {
      request.choices.item(i) = request.choices.item(same);
      request.choices.item(i).placement.centreMm = given.item(i).placement.centreMm;
      tried[i] = tried[same];
      continue;
    }
    const PlanResult found = namingPart(true, one.item().loaded->name, [&] {
      return planAutomatically(one, own, cache, {.onStrategy = observers.onStrategy});
    });
    request.choices.item(i) = found.job.choices.item();
    tried[i] = found.job.report.item().tried;
  }
  PlanResult result = planChosenStrategy(request, ctx.sub(kSearchShare, 1.0), cache, observers);
  for (std::size_t i = 0; i < tried.size(); ++i)
    result.job.report.item(i).tried = std::move(tried[i]);
  return result;
}

project::StageKeys keysOfItem(const project::LoadedPart& loaded, const project::Choices& choices,
                              std::size_t item) {
  const project::Choices own = project::onlyItem(choices, item);
  const bool given = takesGivenPaths(loaded, parameterValues(own));
  Resolved resolved = resolve(given ? choicesForGivenPaths(own) : strategyOrFirst(own));
  resolved.isBesideOthers = choices.items.size() > 1;
  return keysOf(loaded, resolved);
}

} // namespace

PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                    const PlanObservers& observers) {
  checkItems(request.choices);
  if (request.items.size() > 1)
    return planSeveral(request, ctx, cache, observers);
  PlanRequest given = request;
  if (request.choices.item().automatic && !takesGivenPathsOf(given, ctx) && searches(request))
    return planAutomatically(given, ctx, cache, observers);
  return planChosenStrategy(given, ctx, cache, observers);
}

project::StageKeys stageKeys(const PlanRequest& request) {
  checkItems(request.choices);
  std::vector<project::StageKeys> keys;
  for (std::size_t i = 0; i < request.items.size(); ++i) {
    base::require(request.item(i).loaded != nullptr, "stageKeys: parts that are loaded");
    keys.push_back(keysOfItem(*request.item(i).loaded, request.choices, i));
  }
  return joinedKeys(keys, request.choices.printOrder);
}

PlanResult resultOf(project::Job job) {
  checkItems(job.choices);
  PlanResult result = emptyResult(job.choices);
  const process::Process& process = result.tooling().first().process;
  if (std::ranges::all_of(job.items,
                          [](const project::JobItem& item) { return item.platform.known(); }))
    result.cell = std::make_shared<robot::Cell>(
        robot::loadCell(job.choices.cell, process, project::platformOf(job)));
  for (std::size_t i = 0; i < job.items.size(); ++i) {
    project::JobItem& item = job.item(i);
    if (!item.part)
      continue;
    const Resolved& own = *result.item(i).resolved;
    if (!item.placement)
      item.placement = placementByHandOrMode(
          *item.loaded->mesh, item.scale * unitMm(*item.loaded, own.choices), own.modeChoices());
    result.item(i).placed = loadStageOf(job, i, own);
  }
  result.job = std::move(job);
  return result;
}

bool nothingBlocks(const project::Report& report) {
  return std::none_of(report.findings.begin(), report.findings.end(),
                      [](const plan::Finding& f) { return f.blocking; });
}

} // namespace voluta::pipeline
