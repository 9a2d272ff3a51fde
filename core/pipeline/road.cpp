#include "pipeline/road.h"

#include "base/error.h"
#include "base/outcome.h"
#include "base/stopwatch.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/choices.h"
#include "pipeline/given_paths.h"
#include "pipeline/one_way.h"
#include "pipeline/stage_keys.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <optional>

namespace voluta::pipeline {

namespace {

// Several plans: ways of building in turn, until nothing blocks one and no bead of it hangs over
// more than the material bridges. Where all that pass hang, the one that hangs least is taken.
class Automatic {
public:
  Automatic(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
            const StageObserver& onStage, const PreviewObserver& onPreview)
      : request_(request), ctx_(ctx), cache_(cache ? cache : &own_), onStage_(onStage),
        onPreview_(onPreview) {
    if (!request_.loaded)
      request_.loaded = project::loadPart(request_.part, request_.choices.repair, ctx.sub(0, 0.02));
  }

  PlanResult run() {
    const std::vector<project::Choices> ways = automaticChoices(request_.choices);
    std::optional<project::Choices> best;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const auto share = [&](std::size_t k) {
        return 0.02 + 0.98 * static_cast<double>(k) / static_cast<double>(ways.size());
      };
      if (modes::findMode(ways[i].mode).cuts && !request_.loaded->remains.empty()) {
        tried_.push_back({.mode = ways[i].mode,
                          .platform = ways[i].platform.text(),
                          .reason = "pieces are not cut out of a mesh with defects"_text});
        continue;
      }
      if (needsNoSupports(ways[i]))
        continue;
      auto outcome =
          base::outcomeOf([&] { return plan(ways[i], true, ctx_.sub(share(i), share(i + 1))); });
      if (std::holds_alternative<base::Cancelled>(outcome))
        throw base::Cancelled{};
      if (const auto* error = std::get_if<base::Error>(&outcome)) {
        if (!error_)
          error_ = *error;
        tried_.push_back(
            {.mode = ways[i].mode, .platform = ways[i].platform.text(), .reason = error->whole()});
        continue;
      }
      PlanResult& result = std::get<PlanResult>(outcome);
      tried_.push_back(triedAs(ways[i], result.job));
      if (modes::findMode(ways[i].mode).grows && result.job.report.decomposition.voxels > 0 &&
          result.job.report.decomposition.missedVoxels == 0)
        whole_.push_back(butForSupports(ways[i]));
      if (tried_.back().passed) {
        if (tried_.back().reason.empty())
          return taken(tried_.size() - 1, std::move(result));
        if (!hanging_ || longestOf(result) < longestOf(*hanging_)) {
          hanging_ = std::move(result);
          hangingTried_ = tried_.size() - 1;
        }
        continue;
      }
      if (!best || *result.job.reached > furthest_) {
        best = ways[i];
        furthest_ = *result.job.reached;
        bestTried_ = tried_.size() - 1;
      }
    }
    if (hanging_) {
      if (onStage_)
        onStage_(*hanging_->job.reached, *hanging_);
      return taken(hangingTried_, std::move(*hanging_));
    }
    if (!best)
      throw *error_;
    return taken(bestTried_, plan(*best, false, ctx_.quiet()));
  }

private:
  PlanResult plan(const project::Choices& way, bool untilBlocked, const base::RunContext& ctx) {
    PlanRequest one = request_;
    one.choices = way;
    return planOneWay(one, untilBlocked, ctx, cache_, onStage_, onPreview_);
  }
  static project::TriedReport triedAs(const project::Choices& way, const project::Job& job) {
    const project::Report& report = job.report;
    const auto blocking = std::ranges::find_if(report.findings, &plan::Finding::blocking);
    const auto why = blocking != report.findings.end()
                         ? blocking
                         : std::ranges::find(report.findings, plan::FindingKind::LongBridge,
                                             &plan::Finding::kind);
    return {.mode = way.mode,
            .platform = way.platform.text(),
            .passed = blocking == report.findings.end(),
            .stage = std::string(project::stageName(*job.reached)),
            .reason = why == report.findings.end() ? base::Message() : plan::reasonOf(*why)};
  }
  static project::Choices butForSupports(const project::Choices& way) {
    project::Choices choices = byHand(way);
    choices.parameters.erase("supports");
    return choices;
  }
  // Was it tried without supports, and nothing missed? With them it is the same.
  bool needsNoSupports(const project::Choices& way) const {
    const project::Choices choices = butForSupports(way);
    return std::ranges::any_of(whole_, [&](const project::Choices& other) {
      return other.mode == choices.mode && other.platform == choices.platform &&
             other.parameters == choices.parameters;
    });
  }
  static double longestOf(const PlanResult& result) {
    return result.job.report.replay.longestUnsupportedMm;
  }
  PlanResult taken(std::size_t tried, PlanResult result) {
    tried_[tried].taken = true;
    result.job.report.tried = std::move(tried_);
    result.job.report.timings.total = clock_.seconds();
    return result;
  }

  base::Stopwatch clock_;
  PlanRequest request_;
  const base::RunContext& ctx_;
  StageCache own_{1};
  StageCache* cache_;
  const StageObserver& onStage_;
  const PreviewObserver& onPreview_;
  std::vector<project::TriedReport> tried_;
  std::size_t bestTried_ = 0;         // its place among them
  std::optional<PlanResult> hanging_; // passed, but a bead of it hangs
  std::size_t hangingTried_ = 0;
  std::vector<project::Choices> whole_; // of which growth missed nothing
  project::Stage furthest_{};
  std::optional<base::Error> error_; // of the first way that could not be planned
};

// Loads the part where that is not done. Does it bring its tool-paths? Then the request's choices
// are those for them.
bool takesGivenPathsOf(PlanRequest& request, const base::RunContext& ctx) {
  if (!request.loaded)
    request.loaded = project::loadPart(request.part, request.choices.repair, ctx.sub(0, 0.02));
  if (!takesGivenPaths(*request.loaded, parameterValues(request.choices)))
    return false;
  request.choices = choicesForGivenPaths(request.choices);
  return true;
}

} // namespace

PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                    const StageObserver& onStage, const PreviewObserver& onPreview) {
  checkChoices(request.choices);
  PlanRequest given = request;
  if (request.choices.automatic && takesGivenPathsOf(given, ctx))
    return planOneWay(given, false, ctx, cache, onStage, onPreview);
  if (request.choices.automatic)
    return Automatic(given, ctx, cache, onStage, onPreview).run();
  return planOneWay(request, false, ctx, cache, onStage, onPreview);
}

project::StageKeys stageKeys(const PlanRequest& request) {
  base::require(request.loaded != nullptr, "stageKeys: a part that is loaded");
  checkChoices(request.choices);
  const bool given = takesGivenPaths(*request.loaded, parameterValues(request.choices));
  const project::Choices choices =
      byHand(given ? choicesForGivenPaths(request.choices) : wayOrFirst(request.choices));
  const base::ParameterValues values = parameterValues(choices);
  return keysOf(*request.loaded, choices, values, chosenProcess(choices, values));
}

PlanResult resultOf(project::Job job) {
  checkChoices(job.choices);
  PlanResult result;
  const base::ParameterValues values = parameterValues(job.choices);
  result.process = std::make_shared<process::Process>(chosenProcess(job.choices, values));
  if (job.platform.known())
    result.cell = std::make_shared<robot::Cell>(
        robot::loadCell(job.choices.cell, *result.process, job.platform));
  result.debug = values.boolean("output.debug");
  result.keepRefused = values.boolean("output.refused");
  result.proofs = values.boolean("output.proof");
  result.buildFile = values.boolean("output.build3mf");
  if (job.part) {
    if (!job.placement)
      job.placement =
          placementByHandOrMode(*job.loaded->mesh, job.scale * unitMm(*job.loaded, job.choices),
                                {job.choices, values, *result.process});
    result.placed = loadStageOf(job);
  }
  result.job = std::move(job);
  return result;
}

bool nothingBlocks(const project::Report& report) {
  return std::none_of(report.findings.begin(), report.findings.end(),
                      [](const plan::Finding& f) { return f.blocking; });
}

} // namespace voluta::pipeline
