// Plans one way of building: runs its stages in order, taking each from the cache or computing it.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"
#include "pipeline/trial.h"

namespace voluta::pipeline {

// As planPart for manual choices. In a trial, the plan ends at the first blocking finding: the rest
// of that stage is skipped, and the stage is not cached. Throws as planPart does.
PlanResult planChosenStrategy(const PlanRequest& request, const base::RunContext& ctx,
                              StageCache* cache, const PlanObservers& observers,
                              Trial* trial = nullptr);

} // namespace voluta::pipeline
