// Mode auto: plans one way of building after the other (automatic.h) and chooses one of them.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"

namespace voluta::pipeline {

// Returns the plan of the first way that nothing blocks and of which no bead is unsupported over
// more than the material bridges. Where such beads are in every way that passes, the plan in which
// the longest of them is shortest; where no way passes, the plan of the way that came furthest,
// planned to its end. Precondition: request.choices.automatic. Throws as planPart().
PlanResult planAutomatically(const PlanRequest& request, const base::RunContext& ctx,
                             StageCache* cache, const PlanObservers& observers);

} // namespace voluta::pipeline
