// Plans one way of building: runs its stages in order, taking each from the cache or computing it.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"

#include <optional>

namespace voluta::pipeline {

// Why a way of building is rejected, and the stage that found it.
struct Rejection {
  project::Stage stage;
  plan::Finding finding;
};

// A plan that is discarded as soon as a finding blocks it.
struct Trial {
  std::optional<Rejection> rejection; // Set if the plan ended early
};

// As planPart for manual choices. In a trial, the plan ends at the first blocking finding: the rest
// of that stage is skipped, and the stage is not cached. Throws as planPart does.
PlanResult planChosenWay(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                         const PlanObservers& observers, Trial* trial = nullptr);

} // namespace voluta::pipeline
