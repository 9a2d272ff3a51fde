// A plan that is useful only if nothing blocks it, as the search for a way of building makes them.
#pragma once

#include "plan/finding.h"
#include "project/job_stage.h"

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

} // namespace voluta::pipeline
