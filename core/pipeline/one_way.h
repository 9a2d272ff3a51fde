// One plan: the stages of a chosen way of building in order, each taken from the cache or made.
#pragma once

#include "pipeline/road.h"

namespace voluta::pipeline {

// As planPart for choices by hand. `untilBlocked`: what follows the first stage with a blocking
// finding is not made. Throws as planPart does.
PlanResult planOneWay(const PlanRequest& request, bool untilBlocked, const base::RunContext& ctx,
                      StageCache* cache, const StageObserver& onStage,
                      const PreviewObserver& onPreview);

} // namespace voluta::pipeline
