#include "pipeline/compare.h"

#include "base/outcome.h"
#include "base/stopwatch.h"
#include "modes/mode_table.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "project/loaded_part.h"
#include "project/platform_kinds.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace voluta::pipeline {

namespace {

// Returns whether the mode's decomposition depends on this choice.
template <typename T>
bool dependsOnChoice(const modes::Mode& mode, const modes::ModeChoices& in,
                     T project::ItemChoices::*choice, const std::vector<T>& trials) {
  std::set<std::string> keys;
  for (const T& trial : trials) {
    project::Choices choices = in.choices;
    choices.item().*choice = trial;
    keys.insert(mode.decompose.key({choices, in.values, in.process}));
  }
  return keys.size() > 1;
}

// Returns one platform of each kind that the mode prints on, except kinds that need a file.
std::vector<project::Platform> usualPlatforms(const modes::Mode& mode) {
  std::vector<project::Platform> platforms;
  for (const project::PlatformKind* kind : project::platformKindsFor(mode.platforms))
    if (kind->file.empty())
      platforms.emplace_back(*kind);
  return platforms;
}

// Returns the request with the part loaded, so that it is loaded only once; unchanged if it is
// loaded already.
PlanRequest withPart(PlanRequest request, const base::RunContext& ctx) {
  if (!request.item().loaded)
    request.item().loaded =
        project::loadPart(request.item().part, request.choices.item().repair, ctx);
  else
    request.item().loaded =
        project::withRepair(request.item().loaded, request.choices.item().repair, ctx);
  return request;
}

bool takesAll(const modes::Mode& mode, const std::vector<project::Platform>& platforms) {
  return std::all_of(platforms.begin(), platforms.end(), [&](const project::Platform& platform) {
    return platform.isForAnyOf(mode.platforms);
  });
}

template <typename T> std::vector<T> orOwn(const std::vector<T>& list, const T& own) {
  return list.empty() ? std::vector<T>{own} : list;
}

} // namespace

std::vector<Combination> combinations(const CompareOptions& options) {
  const project::Choices& given = options.plan.choices;
  const std::vector<curved::GrowthScheme> growths = orOwn(options.growths, given.item().growth);
  const std::vector<project::Platform> platforms = orOwn(options.platforms, given.item().platform);
  std::vector<std::string> modeIds = options.modes;
  if (modeIds.empty())
    for (const modes::Mode& mode : modes::modeTable())
      if (modes::printAlike(mode, modes::findMode(given.item().mode)) && takesAll(mode, platforms))
        modeIds.emplace_back(mode.id);
  const Resolved resolved = resolve(given);

  std::vector<Combination> all;
  const auto addWays = [&](const std::string& cell, const std::string& id) {
    for (const project::Platform& platform : platforms)
      for (const curved::GrowthScheme& growth : growths) {
        const project::Choices choices = choicesOf({id, growth, platform, cell}, given);
        checkChoices(choices);
        const modes::Mode& mode = modes::findMode(id);
        const modes::ModeChoices in{choices, resolved.values, resolved.process()};
        Combination row{id, growth, platform, cell};
        if (!mode.grows)
          row.growth.reset();
        if (!dependsOnChoice(mode, in, &project::ItemChoices::platform, usualPlatforms(mode)))
          row.platform = platforms.front();
        if (std::find(all.begin(), all.end(), row) == all.end())
          all.push_back(row);
      }
  };
  for (const std::string& cell : orOwn(options.cells, std::string()))
    for (const std::string& id : modeIds)
      addWays(cell, id);
  return all;
}

project::Choices choicesOf(const Combination& combination, project::Choices choices) {
  choices.item().automatic = false;
  choices.item().mode = combination.mode;
  if (combination.growth)
    choices.item().growth = *combination.growth;
  choices.item().platform = combination.platform;
  if (!combination.cell.empty())
    choices.cell = combination.cell;
  return choices;
}

RowState CompareRow::state() const {
  if (!error.empty())
    return RowState::Failed;
  return nothingBlocks(report) ? RowState::Clear : RowState::Blocked;
}

std::size_t CompareRow::blocking() const {
  return static_cast<std::size_t>(std::count_if(report.findings.begin(), report.findings.end(),
                                                [](const auto& f) { return f.blocking; }));
}

base::Message CompareRow::reason() const {
  if (!error.empty())
    return error;
  for (const plan::Finding& f : report.findings)
    if (f.blocking)
      return base::message("{stage}: {reason}"_text, plan::stageName(plan::stageOf(f)),
                           plan::reasonOf(f));
  return {};
}

Comparison compare(const CompareOptions& options, const base::RunContext& ctx,
                   const CompareWatch& watch) {
  const base::Stopwatch whole;
  const std::vector<Combination> all = combinations(options);
  constexpr double kLoadShare = 0.02;
  const PlanRequest request = withPart(options.plan, ctx.sub(0.0, kLoadShare));

  Comparison comparison;
  comparison.part = request.item().loaded->name;
  comparison.choices = request.choices;
  comparison.until = request.until;
  comparison.threads = ctx.threads();
  if (watch.planned)
    watch.planned(all);
  StageCache cache(1);
  const auto share = [&](std::size_t i) {
    return kLoadShare +
           (1.0 - kLoadShare) * static_cast<double>(i) / static_cast<double>(all.size());
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    ctx.checkpoint();
    if (watch.begins)
      watch.begins(i);
    const base::Stopwatch own;
    PlanRequest one = request;
    one.choices = choicesOf(all[i], request.choices);
    CompareRow row;
    row.combination = all[i];
    auto outcome =
        base::outcomeOf([&] { return planPart(one, ctx.sub(share(i), share(i + 1)), &cache); });
    if (std::holds_alternative<base::Cancelled>(outcome))
      throw base::Cancelled{};
    std::shared_ptr<PlanResult> result;
    if (const auto* error = std::get_if<base::Error>(&outcome)) {
      row.error = error->whole();
      row.errorCode = error->code();
    } else {
      result = std::make_shared<PlanResult>(std::move(std::get<PlanResult>(outcome)));
      row.reached = result->job.reached;
      row.report = result->job.report;
    }
    row.seconds = own.seconds();
    comparison.rows.push_back(row);
    if (watch.ended)
      watch.ended(i, comparison.rows.back(), std::move(result));
  }
  comparison.seconds = whole.seconds();
  return comparison;
}

} // namespace voluta::pipeline
