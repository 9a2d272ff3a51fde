// The stages of the road, in order (docs/design.md, Stages).
#pragma once

#include "base/text.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace voluta::plan {

enum class Stage { Load, Decompose, Layers, Toolpath, Motion, Replay };
inline constexpr std::size_t kStageCount = 6;

// "load", "decompose", "layers", "toolpath", "motion", "replay": as on the command line.
std::string_view stageName(Stage stage);
// How it is called in headings.
base::Text stageLabel(Stage stage);
std::optional<Stage> stageNamed(std::string_view name);

inline constexpr std::size_t indexOf(Stage stage) {
  return static_cast<std::size_t>(stage);
}

} // namespace voluta::plan
