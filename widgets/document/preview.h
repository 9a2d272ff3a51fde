// Intermediate results of a plan, shown before the stage is done.
#pragma once

#include "pipeline/plan_result.h"

#include <memory>
#include <string>

namespace voluta::document {

// Voxels of a decomposition that is still being computed.
struct Preview {
  std::shared_ptr<const curved::Decomposition> decomposition;
  double layerHeightMm = 0.0;
  std::string loadKey; // of the placement of the part
  std::string partHash;
};
// `soFar` has its Load stage.
Preview previewOf(std::shared_ptr<const curved::Decomposition> decomposition,
                  const pipeline::PlanResult& soFar);

} // namespace voluta::document
