// The stages of the road, in order (docs/design.md, Stages).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace voluta::project {

enum class Stage { Load, Decompose, Layers, Toolpath, Motion, Replay };
inline constexpr std::size_t kStageCount = 6;

// "load", "decompose", "layers", "toolpath", "motion", "replay": as on the command line.
std::string_view stageName(Stage stage);
// Throws Error{Usage} for an unknown name, naming the nearest.
Stage stageOf(const std::string& name);

inline constexpr std::size_t indexOf(Stage stage) {
  return static_cast<std::size_t>(stage);
}

// What went into each stage, as text: equal keys, equal results. Empty where there is no result.
using StageKeys = std::array<std::string, kStageCount>;

} // namespace voluta::project
