#include "document/preview.h"

#include "curved/decomposition.h"
#include "project/loaded_part.h"

#include <utility>

namespace voluta::document {

Preview previewOf(std::shared_ptr<const curved::Decomposition> decomposition,
                  const pipeline::PlanResult& soFar) {
  return {std::move(decomposition), soFar.tooling().first().process.layerHeightMm,
          soFar.job.stages[project::indexOf(project::Stage::Load)].key,
          soFar.job.item().loaded->hash};
}

} // namespace voluta::document
