#include "plan/stage.h"

#include <algorithm>

namespace voluta::plan {

namespace {
struct Row {
  std::string_view name;
  base::Text label;
};
constexpr std::array<Row, kStageCount> kRows{{{"load", "Load"_text},
                                              {"decompose", "Decomposition"_text},
                                              {"layers", "Layers"_text},
                                              {"toolpath", "Tool-paths"_text},
                                              {"motion", "Motion"_text},
                                              {"replay", "Replay"_text}}};
} // namespace

std::string_view stageName(Stage stage) {
  return kRows[indexOf(stage)].name;
}

base::Text stageLabel(Stage stage) {
  return kRows[indexOf(stage)].label;
}

std::optional<Stage> stageNamed(std::string_view name) {
  const auto found =
      std::find_if(kRows.begin(), kRows.end(), [&](const Row& row) { return row.name == name; });
  if (found == kRows.end())
    return std::nullopt;
  return static_cast<Stage>(found - kRows.begin());
}

} // namespace voluta::plan
