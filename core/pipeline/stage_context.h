// What all stages of one plan share: cache, progress, and the rejection of a trial.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"
#include "pipeline/trial.h"
#include "project/job_stage.h"

#include <memory>
#include <string>

namespace voluta::pipeline {

class StageContext {
public:
  // All of them outlive it. `cache` and `trial` may be null.
  StageContext(project::Stage until, const base::RunContext& ctx, StageCache* cache,
               const PlanObservers& observers, Trial* trial)
      : until_(until), ctx_(ctx), cache_(cache), observers_(observers), trial_(trial) {}

  project::Stage until() const { return until_; }
  StageCache* cache() const { return cache_; }
  const PlanObservers& observers() const { return observers_; }
  bool isTrial() const { return trial_ != nullptr; }

  // The progress of a stage within this plan.
  base::RunContext span(project::Stage stage) const;

  // Returns the stage with that key from the cache, else makes it and keeps it. Throws Cancelled.
  template <typename T, typename Make>
  std::shared_ptr<const T> cachedOrMade(const std::string& key, const std::string& slot,
                                        Make make) const {
    std::shared_ptr<const T> stage = cache_ ? cache_->find<T>(key, slot) : nullptr;
    if (stage)
      return stage;
    stage = make();
    ctx_.checkpoint();
    if (cache_ && !isRejected())
      cache_->keep<T>(key, stage, slot);
    return stage;
  }

  bool isRejected() const { return trial_ && trial_->rejection; }
  // In a trial: the first blocking finding ends the plan. Returns whether it has ended.
  bool reject(project::Stage stage, const plan::Findings& findings) const;

private:
  project::Stage until_;
  const base::RunContext& ctx_;
  StageCache* cache_;
  const PlanObservers& observers_;
  Trial* trial_;
};

} // namespace voluta::pipeline
