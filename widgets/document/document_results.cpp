// The results of a document: shown plans, their states and keys.
#include "document/document.h"
#include "document/document_parts.h"
#include "document/item_result.h"
#include "document/stage_at.h"
#include "pipeline/checked_program.h"
#include "pipeline/plan_verdict.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace voluta::document {

using project::indexOf;
using project::kStageCount;
using project::Stage;

void Document::refreshKeys() {
  keys_ = {};
  unusable_.reset();
  if (!parts_)
    return;
  try {
    keys_ = pipeline::stageKeys(request(Stage::Replay));
  } catch (const base::Error& error) {
    unusable_ = error;
  }
}

void Document::showResults(ShownStages results) {
  failure_.reset();
  shownBefore_ = {};
  dropPreview();
  std::swap(shown_, results);
  for (std::size_t s = 0; s < kStageCount; ++s)
    if (shown_[s].result != results[s].result)
      emit resultChanged(stageAt(s));
}

void Document::keepResultsOf(const std::shared_ptr<Parts>& left) {
  constexpr int kPlans = 2;
  std::vector<std::shared_ptr<Parts>> earlier;
  for (auto at = left_.lock(); at; at = at->leftBefore.lock())
    if (at != left)
      earlier.push_back(at);
  left->results = shown_;
  left_ = left;
  std::shared_ptr<Parts> last = left;
  int plans = left->results[indexOf(Stage::Toolpath)].result ? 1 : 0;
  for (const std::shared_ptr<Parts>& at : earlier) {
    if (at->results[indexOf(Stage::Toolpath)].result && ++plans > kPlans)
      at->results = {};
    last->leftBefore = at;
    last = at;
  }
  last->leftBefore.reset();
}

std::shared_ptr<const pipeline::PlanResult> Document::result(Stage stage) const {
  return shown_[indexOf(stage)].result;
}

std::shared_ptr<const pipeline::PlanResult> Document::itemResult(Stage stage) const {
  const auto& all = shown_[indexOf(stage)].result;
  if (!all || all->job.items.size() < 2)
    return all;
  ItemShown& shown = itemShown_[indexOf(stage)];
  if (shown.of != all || shown.item != active_)
    shown = {all, std::make_shared<const pipeline::PlanResult>(onlyItem(*all, active_)), active_};
  return shown.one;
}

std::shared_ptr<const pipeline::PlanResult> Document::lastResult() const {
  for (std::size_t s = kStageCount; s-- > 0;)
    if (shown_[s].result)
      return shown_[s].result;
  return nullptr;
}

std::shared_ptr<const pipeline::PlanResult> Document::presentResult() const {
  for (std::size_t s = kStageCount; s-- > indexOf(Stage::Decompose);)
    if (upToDate(stageAt(s)))
      return shown_[s].result;
  return lastResult();
}

bool Document::ahead(Stage stage) const {
  const std::size_t s = indexOf(stage);
  if (!upToDate(stage) || s + 1 == kStageCount)
    return false;
  const auto& next = shown_[s + 1].result;
  return !next || (next != shown_[s].result && next->job.stages[s].key != shown_[s].key);
}

bool Document::voxelsAhead() const {
  return preview_ || ahead(Stage::Decompose);
}

bool Document::voxelsInPlace() const {
  const std::string& now = key(Stage::Load);
  if (now.empty())
    return false;
  if (preview_)
    return preview_->loadKey == now;
  const auto result = this->result(Stage::Decompose);
  return result && result->job.stages[indexOf(Stage::Load)].key == now;
}

bool Document::isRest() const {
  const auto motion = result(Stage::Motion);
  return motion && motion->job.resumedAt > 0 && upToDate(Stage::Motion);
}

std::string Document::shownKey(const pipeline::PlanResult& result, std::size_t stage,
                               const project::StageKeys& keys) {
  const std::string& key = result.job.stages[stage].key;
  return key == project::kResumedKey ? keys[stage] : key;
}

const Failure* Document::failure() const {
  return failure_ && state(failure_->stage) == StageState::Failed ? &*failure_ : nullptr;
}

bool Document::upToDate(Stage stage) const {
  const std::size_t s = indexOf(stage);
  return shown_[s].result && !keys_[s].empty() && shown_[s].key == keys_[s];
}

StageState Document::state(Stage stage) const {
  const std::size_t s = indexOf(stage);
  if (running_ == stage)
    return StageState::Running;
  if (!running_ && failure_ && failure_->stage == stage && runKeys_[s] == keys_[s])
    return StageState::Failed;
  if (!shown_[s].result)
    return StageState::Nothing;
  if (!upToDate(stage))
    return StageState::OutOfDate;
  const plan::Findings& findings = shown_[s].result->job.report.findings;
  // The last stage hands over the whole plan.
  if (stage == Stage::Replay) {
    const pipeline::PlanVerdict verdict = pipeline::verdictOf(shown_[s].result->job.report);
    if (verdict != pipeline::PlanVerdict::Passed)
      return pipeline::isRefused(verdict) ? StageState::Blocked : StageState::Differs;
  }
  const auto anyHere = [&](const auto& blocks) {
    return std::ranges::any_of(
        findings, [&](const plan::Finding& f) { return plan::stageOf(f) == stage && blocks(f); });
  };
  if (anyHere(plan::blocksRunning))
    return StageState::Blocked;
  if (anyHere([](const plan::Finding& f) { return f.blocking; }))
    return StageState::Differs;
  // A reopened project has its verdict, but no programs to export.
  const bool toHandOver = stage != Stage::Replay || !shown_[s].result->checked.empty();
  return toHandOver ? StageState::Done : StageState::Nothing;
}

void Document::planStarted(Stage until) {
  if (!running_) // on a restart, the results of the aborted run are not those from before it
    shownBefore_ = shown_;
  running_ = Stage::Load;
  until_ = until;
  runKeys_ = keys_;
  failure_.reset();
  emit stateChanged();
}

bool Document::isOfSource(const pipeline::PlanResult& result) const {
  return parts_ && std::ranges::equal(parts_->items, result.job.items,
                                      [](const auto& source, const project::JobItem& item) {
                                        return item.loaded &&
                                               item.loaded->hash == source->part->hash;
                                      });
}

void Document::stageDone(Stage stage, std::shared_ptr<const pipeline::PlanResult> result) {
  if (!isOfSource(*result))
    return;
  takeStrategy(result->job.choices);
  const std::size_t done = indexOf(stage);
  const bool changed = shown_[done].key != shownKey(*result, done, runKeys_) ||
                       !shown_[done].result ||
                       stage == Stage::Replay; // a reopened project lacks the programs
  for (std::size_t s = 0; s <= done; ++s)
    shown_[s] = {result, shownKey(*result, s, runKeys_)};
  const bool aheadBefore = preview_ && stage == Stage::Decompose;
  if (aheadBefore)
    preview_.reset();
  running_ = stage < until_ ? std::optional(stageAt(done + 1)) : std::nullopt;
  if (changed)
    emit resultChanged(stage);
  else if (aheadBefore)
    emit previewChanged();
  emit stateChanged();
  emitDirtyAndName();
}

void Document::takeStrategy(const project::Choices& planned) {
  bool taken = false;
  for (std::size_t i = 0; i < choices_.items.size() && i < planned.items.size(); ++i) {
    project::ItemChoices& own = choices_.item(i);
    const project::ItemChoices& found = planned.item(i);
    if (!own.automatic || !found.automatic ||
        (found.automaticStrategy == own.automaticStrategy && found.mode == own.mode &&
         found.platform == own.platform))
      continue;
    own.automaticStrategy = found.automaticStrategy;
    own.mode = found.mode;
    if (!own.platformStays)
      own.platform = found.platform;
    taken = true;
  }
  if (!taken)
    return;
  activeChoices_ = project::onlyItem(choices_, active_);
  refreshKeys();
  emit choicesChanged();
}

void Document::planEnded(std::shared_ptr<const pipeline::PlanResult> result) {
  if (result->job.reached && isOfSource(*result))
    for (std::size_t s = 0; s <= indexOf(*result->job.reached); ++s)
      shown_[s].result = result;
  endRun();
  if (until_ > Stage::Load)
    dropPreview();
  emit stateChanged();
  emitDirtyAndName();
}

void Document::planCancelled() {
  // number of stages that the run has completed
  const std::size_t came = running_ ? indexOf(*running_) : 0;
  const bool further = std::any_of(shownBefore_.begin() + static_cast<std::ptrdiff_t>(came),
                                   shownBefore_.end(), [](const Shown& s) { return s.result; });
  const ShownStages before = shownBefore_;
  endRun();
  dropPreview();
  // Except the first: the part's position corresponds to the numbers.
  for (std::size_t s = 1; further && s < came; ++s) {
    const bool changed = shown_[s].key != before[s].key;
    shown_[s] = before[s];
    if (changed)
      emit resultChanged(stageAt(s));
  }
  emit stateChanged();
  emitDirtyAndName();
}

void Document::endRun() {
  running_.reset();
  shownBefore_ = {};
}

Stage Document::planFailed(const base::Error& error) {
  const Stage where = running_.value_or(until_);
  failure_ = Failure{where, error};
  endRun();
  dropPreview();
  emit stateChanged();
  return where;
}

void Document::showPreview(Preview preview) {
  // A preview does not name its part.
  if (partCount() != 1 || preview.partHash != source()->hash)
    return;
  preview_ = std::move(preview);
  emit previewChanged();
  emit stateChanged();
}

void Document::dropPreview() {
  if (!preview_)
    return;
  preview_.reset();
  emit previewChanged();
  emit stateChanged();
}

void Document::previewDone(std::shared_ptr<const pipeline::PlanResult> result) {
  if (!isOfSource(*result))
    return;
  takeStrategy(result->job.choices);
  for (const Stage stage : {Stage::Load, Stage::Decompose}) {
    const std::string& key = result->job.stages[indexOf(stage)].key;
    Shown& shown = shown_[indexOf(stage)];
    const bool changed = shown.key != key || !shown.result;
    shown = {result, key};
    if (stage == Stage::Decompose)
      preview_.reset();
    if (changed || stage == Stage::Decompose)
      emit resultChanged(stage);
  }
  emit stateChanged();
}

void Document::previewFailed(const base::Error& error) {
  failure_ = Failure{Stage::Decompose, error};
  runKeys_ = keys_;
  dropPreview();
  emit stateChanged();
}

pipeline::PlanRequest Document::request(Stage until) const {
  pipeline::PlanRequest request;
  request.items.clear();
  for (const auto& part : sources())
    request.items.push_back({{}, part});
  if (request.items.empty())
    request.items.emplace_back();
  request.choices = choices_;
  request.until = until;
  return request;
}

pipeline::PlanRequest Document::itemRequest(Stage until) const {
  pipeline::PlanRequest request;
  request.item().loaded = source();
  request.choices = activeChoices_;
  request.until = until;
  return request;
}

project::Job Document::snapshot() const {
  std::size_t current = 0; // number of leading stages whose results are those of the choices
  while (current < kStageCount && upToDate(stageAt(current)))
    ++current;
  project::Job job;
  if (current > 0)
    job = project::upTo(shown_[current - 1].result->job, stageAt(current - 1));
  job.choices = choices_;
  job.items.resize(choices_.items.size());
  job.report.items.resize(choices_.items.size());
  const std::vector<std::shared_ptr<const project::LoadedPart>> parts = sources();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    job.item(i).loaded = parts[i];
    job.item(i).partName = parts[i]->name;
  }
  return job;
}

} // namespace voluta::document
