// What is shown of a plan before its stage is done.
#pragma once

#include "pipeline/plan_result.h"

#include <memory>
#include <string>

namespace voluta::document {

// Voxels of a decomposition that is still being made.
struct Preview {
  std::shared_ptr<const curved::Decomposition> decomposition;
  double layerHeightMm = 0.0;
  std::string loadKey; // of how the part was placed
  std::string partHash;
};
// `soFar` has its Load stage.
Preview previewOf(std::shared_ptr<const curved::Decomposition> decomposition,
                  const pipeline::PlanResult& soFar);

} // namespace voluta::document
