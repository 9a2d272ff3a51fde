#include "pipeline/stage_cache.h"

#include "layers/layer_stack.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/cell_plate.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "project/job.h"
#include "project/loaded_part.h"

#include <algorithm>

namespace voluta::pipeline {

StageCache::Value StageCache::findAny(project::Stage stage, const std::string& slot,
                                      const std::string& key) {
  Value found = findHere(stage, slot, key);
  if (!found && behind_)
    if (found = behind_->findAny(stage, slot, key); found)
      keepHere(stage, slot, key, found);
  return found;
}

void StageCache::keepAny(project::Stage stage, const std::string& slot, const std::string& key,
                         const Value& value) {
  keepHere(stage, slot, key, value);
  if (behind_)
    behind_->keepAny(stage, slot, key, value);
}

StageCache::Value StageCache::findHere(project::Stage stage, const std::string& slot,
                                       const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto shelf = shelves_.find({stage, slot});
  if (shelf == shelves_.end())
    return nullptr;
  auto& kept = shelf->second;
  const auto found =
      std::find_if(kept.begin(), kept.end(), [&](const auto& entry) { return entry.first == key; });
  if (found == kept.end())
    return nullptr;
  std::rotate(kept.begin(), found, found + 1);
  return kept.front().second;
}

void StageCache::keepHere(project::Stage stage, const std::string& slot, const std::string& key,
                          Value value) {
  std::vector<Value> dropped; // freed outside the lock: results may be large
  const std::lock_guard lock(mutex_);
  auto& kept = shelves_[{stage, slot}];
  const auto same =
      std::find_if(kept.begin(), kept.end(), [&](const auto& entry) { return entry.first == key; });
  if (same != kept.end()) {
    dropped.push_back(std::move(same->second));
    kept.erase(same);
  }
  kept.insert(kept.begin(), {key, std::move(value)});
  while (kept.size() > kept_) {
    dropped.push_back(std::move(kept.back().second));
    kept.pop_back();
  }
}

void StageCache::clear() {
  decltype(shelves_) dropped;
  const std::lock_guard lock(mutex_);
  dropped.swap(shelves_);
}

namespace {
// Returns whether the job's mode exists and its result is of that mode's kind.
bool holdsResult(const project::Job& job) {
  const modes::Mode* mode = modes::modeNamed(job.choices.item().mode);
  return mode && mode->result == project::kindOf(job.item().result);
}
} // namespace

std::shared_ptr<modes::LoadStage> loadStageOf(const project::Job& job, std::size_t index,
                                              const Resolved& resolved) {
  const project::JobItem& item = job.item(index);
  auto load = std::make_shared<modes::LoadStage>();
  load->scale = item.scale;
  load->placement = item.placement.value_or(job.choices.item(index).placement);
  load->part = item.part;
  if (item.part && job.choices.item(index).platform.isOfCell())
    load->platform = cellPlate(fittingCell(resolved.choices, resolved.process()), *item.part,
                               plateNeeds(resolved.modeChoices()));
  return load;
}

void seedCache(StageCache& cache, const project::Job& job) {
  if (!job.reached)
    return;
  std::size_t firstFinding = 0;
  const auto& all = job.report.findings;
  const auto seed = [&](auto stage, const auto& report, plan::Findings* findings) {
    using T = typename decltype(stage)::element_type;
    const project::StageRecord& record = job.stages[project::indexOf(T::kStage)];
    if (findings)
      findings->assign(all.begin() + static_cast<std::ptrdiff_t>(firstFinding),
                       all.begin() + static_cast<std::ptrdiff_t>(firstFinding + record.findings));
    firstFinding += record.findings;
    stage->report = report;
    stage->timings = record.timings;
    // The file lacks a voxel object's placed cells; they are quick to compute again.
    // The records of several items are joined up to the layers.
    const bool whole = T::kStage <= project::Stage::Layers && job.items.size() > 1 ? false
                       : T::kStage == project::Stage::Load
                           ? !job.item().loaded || !job.item().loaded->cells
                       : T::kStage == project::Stage::Decompose ? holdsResult(job)
                                                                : true;
    if (whole && *job.reached >= T::kStage && !record.key.empty())
      cache.keep<T>(record.key, stage);
  };
  auto load = loadStageOf(job, 0, resolve(job.choices));
  seed(load, job.report.item().model, nullptr);
  auto decompose = std::make_shared<modes::DecomposeStage>();
  decompose->platform = job.item().platform;
  decompose->result = job.item().result;
  seed(decompose, job.report.item().decomposition, &decompose->findings);
  auto layers = std::make_shared<modes::LayersStage>();
  layers->layers = job.item().layers;
  seed(layers, job.report.item().layers, &layers->findings);
  auto toolpath = std::make_shared<ToolpathStage>();
  toolpath->toolPlan = job.toolPlan;
  seed(toolpath, job.report.toolpath, &toolpath->findings);
  auto motion = std::make_shared<MotionStage>();
  motion->trajectory = job.trajectory;
  seed(motion, job.report.motion, &motion->findings);
}

} // namespace voluta::pipeline
