// One plan: the stages of a chosen way of building in order, each taken from the cache or made.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"

#include <optional>

namespace voluta::pipeline {

// Why a way of building cannot pass, and after which stage that was known.
struct Rejection {
  project::Stage stage;
  plan::Finding finding;
};

// A plan that is of use only if nothing blocks it.
struct Trial {
  std::optional<Rejection> rejection; // set where the plan ended early
};

// As planPart for choices by hand. With a trial, the plan ends as soon as it is known that
// something blocks it: what a stage had left to do then is not done, and that stage is not kept in
// the cache. Throws as planPart does.
PlanResult planChosenWay(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                         const PlanObservers& observers, Trial* trial = nullptr);

} // namespace voluta::pipeline
