#include "project/stage.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <vector>

namespace voluta::project {

namespace {
constexpr std::array<std::string_view, kStageCount> kNames{"load",     "decompose", "layers",
                                                           "toolpath", "motion",    "replay"};
}

std::string_view stageName(Stage stage) {
  return kNames[indexOf(stage)];
}

Stage stageOf(const std::string& name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end())
    throw base::Error(
        base::ErrorCode::Usage, "unknown stage '" + name + "'", {},
        "did you mean " +
            base::nearestName(name, std::vector<std::string>(kNames.begin(), kNames.end())) + "?");
  return static_cast<Stage>(found - kNames.begin());
}

} // namespace voluta::project
