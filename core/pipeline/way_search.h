// Mode auto: plans several ways of building (automatic.h) one after another and chooses one.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"

namespace voluta::pipeline {

// Returns the first plan that nothing blocks and that has no unsupported bead longer than the
// material bridges. If all plans that pass have such beads, returns the plan in which the longest
// of them is shortest. If no plan passes, returns the plan of the way that got furthest, planned to
// its end. If only formats and their options have changed since a search whose results are in the
// cache, keeps the way that it chose. Precondition: request.choices.automatic. Throws as
// planPart().
PlanResult planAutomatically(const PlanRequest& request, const base::RunContext& ctx,
                             StageCache* cache, const PlanObservers& observers);

} // namespace voluta::pipeline
