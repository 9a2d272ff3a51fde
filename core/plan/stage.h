// The stages of the pipeline, in order (docs/design.md, Stages).
#pragma once

#include "base/text.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace voluta::plan {

enum class Stage { Load, Decompose, Layers, Toolpath, Motion, Replay };
inline constexpr std::size_t kStageCount = 6;

// Returns "load", "decompose", "layers", "toolpath", "motion" or "replay", as used on the command
// line.
std::string_view stageName(Stage stage);
// Returns the stage's name for headings.
base::Text stageLabel(Stage stage);
std::optional<Stage> stageNamed(std::string_view name);

inline constexpr std::size_t indexOf(Stage stage) {
  return static_cast<std::size_t>(stage);
}

} // namespace voluta::plan
