#include "pipeline/way_search.h"

#include "base/error.h"
#include "base/outcome.h"
#include "base/stopwatch.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/road.h"
#include "pipeline/stage_runner.h"
#include "pipeline/stages.h"
#include "placement/terraced.h"
#include "plan/finding_kinds.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace voluta::pipeline {

namespace {

constexpr double kLoaded = 0.02; // share of the progress for loading the part

// Returns whether a finding concerns the loaded part, so that every way of building has it.
bool concernsPartAlone(plan::FindingKind kind) {
  using enum plan::FindingKind;
  return kind == OpenRims || kind == SheetModel || kind == TinyPart || kind == HugePart;
}

class StrategySearch {
public:
  StrategySearch(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                 const PlanObservers& observers)
      : request_(request), ctx_(ctx), cache_(cache ? cache : &own_), observers_(observers) {
    if (!request_.item().loaded)
      request_.item().loaded = project::loadPart(
          request_.item().part, request_.choices.item().repair, ctx.sub(0, kLoaded));
  }

  PlanResult run() {
    const std::vector<project::Choices> ways = orderedWays();
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (needsNoSupports(ways[i]))
        continue;
      if (observers_.onStrategy)
        observers_.onStrategy({nameOfStrategy(ways[i]), i + 1, ways.size()});
      const auto begin = [&](std::size_t k) {
        return kLoaded +
               (1.0 - kLoaded) * static_cast<double>(k) / static_cast<double>(ways.size());
      };
      if (tryStrategy(ways[i], ctx_.sub(begin(i), begin(i + 1))))
        return choose(*passed_);
      if (isPartRefused_)
        break;
    }
    if (passed_) {
      if (observers_.onStage)
        observers_.onStage(*passed_->result.job.reached, passed_->result);
      return choose(*passed_);
    }
    if (!failed_)
      throw *error_;
    failed_->result = planStrategy(failed_->strategy, ctx_.quiet(), *failed_->stages, nullptr);
    return choose(*failed_);
  }

private:
  struct Candidate {
    project::Choices strategy;
    std::size_t tried = 0; // index of its row in tried_
    // its results so far, from which it can be planned to its end
    std::unique_ptr<StageCache> stages;
    PlanResult result = PlanResult();
    project::Stage rejectedBy = {};
  };

  bool isTerraced() const {
    const project::LoadedPart& loaded = *request_.item().loaded;
    const Eigen::Quaterniond& rotation = request_.choices.item().placement.rotation;
    return !loaded.cells && !loaded.open && !loaded.mesh->empty() &&
           placement::isTerraced(*loaded.mesh, rotation.normalized().toRotationMatrix());
  }

  std::vector<project::Choices> orderedWays() const {
    std::vector<project::Choices> ways = automaticChoices(request_.choices);
    const auto terraced = std::ranges::stable_partition(ways, [](const project::Choices& way) {
      return way.item().automaticStrategy == kTerraced;
    });
    if (!isTerraced())
      ways.erase(ways.begin(), terraced.begin());
    return ways;
  }

  PlanResult planStrategy(const project::Choices& strategy, const base::RunContext& ctx,
                          StageCache& stages, Trial* trial) {
    PlanRequest one = request_;
    one.choices = strategy;
    return planChosenStrategy(one, ctx, &stages, observers_, trial);
  }

  // Returns whether the mesh that this way would print has defects. A part that cannot be placed
  // has none here: planning the way itself reports the reason.
  bool hasDefects(const project::Choices& strategy) {
    if (!request_.item().loaded->open)
      return !remainingDefects(*request_.item().loaded).empty();
    PlanRequest start = request_;
    start.choices = strategy;
    start.until = project::Stage::Load;
    const auto outcome = base::outcomeOf(
        [&] { return planChosenStrategy(start, ctx_.quiet(), cache_, PlanObservers()); });
    if (std::holds_alternative<base::Cancelled>(outcome))
      throw base::Cancelled{};
    const auto* placed = std::get_if<PlanResult>(&outcome);
    return placed && std::ranges::find(placed->job.report.findings, plan::FindingKind::MeshDefect,
                                       &plan::Finding::kind) != placed->job.report.findings.end();
  }

  // Returns true if the search ends with this way.
  bool tryStrategy(const project::Choices& strategy, const base::RunContext& ctx) {
    project::TriedReport& row = tried_.emplace_back();
    row.strategy = strategy.item().automaticStrategy;
    row.name = nameOfStrategy(strategy);
    row.mode = strategy.item().mode;
    row.platform = strategy.item().platform.text();
    if (modes::findMode(strategy.item().mode).cuts && hasDefects(strategy)) {
      row.reason = "a mesh with defects cannot be cut into pieces"_text;
      return false;
    }
    Trial trial;
    Candidate candidate{strategy, tried_.size() - 1, std::make_unique<StageCache>(1, cache_)};
    auto outcome =
        base::outcomeOf([&] { return planStrategy(strategy, ctx, *candidate.stages, &trial); });
    if (std::holds_alternative<base::Cancelled>(outcome))
      throw base::Cancelled{};
    if (const auto* error = std::get_if<base::Error>(&outcome)) {
      row.reason = error->whole();
      if (!error_)
        error_ = *error;
      return false;
    }
    candidate.result = std::move(std::get<PlanResult>(outcome));
    row.stage = project::stageName(*candidate.result.job.reached);
    noteLosses(candidate);
    if (trial.rejection) {
      row.reason = plan::reasonOf(trial.rejection->finding);
      candidate.rejectedBy = plan::stageOf(trial.rejection->finding);
      isPartRefused_ = concernsPartAlone(trial.rejection->finding.kind);
      keepFailed(std::move(candidate));
      return false;
    }
    row.passed = true;
    candidate.stages.reset();
    return keepPassed(std::move(candidate));
  }

  void keepFailed(Candidate candidate) {
    candidate.result = PlanResult(); // The stages stay in the candidate's cache.
    if (!failed_ || candidate.rejectedBy > failed_->rejectedBy)
      failed_ = std::move(candidate);
  }

  // Returns true if no bead is unsupported over more than the material bridges.
  bool keepPassed(Candidate candidate) {
    const plan::Findings& findings = candidate.result.job.report.findings;
    const auto bridge =
        std::ranges::find(findings, plan::FindingKind::LongBridge, &plan::Finding::kind);
    const bool isBridged = bridge == findings.end();
    if (!isBridged)
      tried_[candidate.tried].reason = plan::reasonOf(*bridge);
    if (isBridged || !passed_ || longestOf(candidate) < longestOf(*passed_))
      passed_ = std::move(candidate);
    return isBridged;
  }
  static double longestOf(const Candidate& candidate) {
    return candidate.result.job.report.replay.longestUnsupportedMm;
  }

  // If growth misses nothing without supports, the same way with supports gives the same plan.
  void noteLosses(const Candidate& candidate) {
    const project::DecompositionReport& r = candidate.result.job.report.item().decomposition;
    if (modes::findMode(candidate.strategy.item().mode).grows && r.voxels > 0 &&
        r.missedVoxels == 0)
      missedNothing_.push_back(withoutSupports(candidate.strategy));
  }
  bool needsNoSupports(const project::Choices& strategy) const {
    const project::Choices choices = withoutSupports(strategy);
    return std::ranges::any_of(missedNothing_, [&](const project::Choices& other) {
      return other.item().mode == choices.item().mode &&
             other.item().platform == choices.item().platform &&
             other.item().parameters == choices.item().parameters;
    });
  }
  static project::Choices withoutSupports(const project::Choices& strategy) {
    project::Choices choices = resolved(strategy);
    choices.item().parameters.erase("supports");
    return choices;
  }

  PlanResult choose(Candidate& candidate) {
    tried_[candidate.tried].taken = true;
    PlanResult result = std::move(candidate.result);
    result.job.report.item().tried = std::move(tried_);
    result.job.report.timings.total = clock_.seconds();
    return result;
  }

  base::Stopwatch clock_;
  PlanRequest request_;
  const base::RunContext& ctx_;
  StageCache own_{1};
  StageCache* cache_;
  const PlanObservers& observers_;
  std::vector<project::TriedReport> tried_;
  std::optional<Candidate> passed_, failed_; // the best so far
  std::vector<project::Choices> missedNothing_;
  bool isPartRefused_ = false;       // if so, no other way of building can pass
  std::optional<base::Error> error_; // of the first way that could not be planned
};

// Kept with the motion of the way that a search has chosen.
struct FoundStrategy {
  static constexpr project::Stage kStage = project::Stage::Motion;
  std::vector<project::TriedReport> tried;
};
constexpr const char* kStrategySlot = "way";

// Returns the search that chose the way that the choices name, if since then nothing has changed
// but the formats and their options. Null: there is none, or the formats do not allow the way.
std::shared_ptr<const FoundStrategy> foundBefore(const PlanRequest& request, StageCache* cache) {
  if (!cache || !request.item().loaded || !namesStrategy(request.choices))
    return nullptr;
  const std::vector<project::Choices> ways = automaticChoices(request.choices);
  const bool isAllowed = std::ranges::any_of(ways, [&](const project::Choices& strategy) {
    return strategy.item().automaticStrategy == request.choices.item().automaticStrategy;
  });
  return isAllowed
             ? cache->find<FoundStrategy>(
                   stageKeys(request)[project::indexOf(project::Stage::Motion)], kStrategySlot)
             : nullptr;
}

// A way is only kept if nothing blocks it: of another format it may not be the best one.
void keepFound(const PlanResult& result, StageCache* cache) {
  const std::string& key = result.job.stages[project::indexOf(project::Stage::Motion)].key;
  if (cache && !key.empty() && nothingBlocks(result.job.report))
    cache->keep(
        key, std::make_shared<const FoundStrategy>(FoundStrategy{result.job.report.item().tried}),
        kStrategySlot);
}

} // namespace

PlanResult planAutomatically(const PlanRequest& request, const base::RunContext& ctx,
                             StageCache* cache, const PlanObservers& observers) {
  if (const auto found = foundBefore(request, cache)) {
    PlanResult result = planChosenStrategy(request, ctx, cache, observers);
    result.job.report.item().tried = found->tried;
    return result;
  }
  PlanResult result = StrategySearch(request, ctx, cache, observers).run();
  keepFound(result, cache);
  return result;
}

} // namespace voluta::pipeline
