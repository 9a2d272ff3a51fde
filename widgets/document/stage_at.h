// The inverse of project::indexOf().
#pragma once

#include "project/job_stage.h"

#include <cstddef>

namespace voluta::document {

// Precondition: index < project::kStageCount.
inline project::Stage stageAt(std::size_t index) {
  return static_cast<project::Stage>(index);
}

} // namespace voluta::document
