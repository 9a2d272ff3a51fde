#include "project/job_stage.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <vector>

namespace voluta::project {

Stage stageOf(const std::string& name) {
  if (const std::optional<Stage> stage = plan::stageNamed(name))
    return *stage;
  std::vector<std::string> known;
  for (std::size_t i = 0; i < kStageCount; ++i)
    known.emplace_back(stageName(static_cast<Stage>(i)));
  throw base::Error(base::ErrorCode::Usage, base::message("unknown stage '{name}'"_text, name), {},
                    base::didYouMean(name, known));
}

} // namespace voluta::project
