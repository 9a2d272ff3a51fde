// The stages of the pipeline, in order (docs/design.md, Stages).
#pragma once

#include "plan/stage.h"

#include <array>
#include <string>

namespace voluta::project {

using plan::indexOf;
using plan::kStageCount;
using plan::Stage;
using plan::stageName;

// Throws Error{Usage} for an unknown name, naming the nearest.
Stage stageOf(const std::string& name);

// The inputs of each stage as text: equal keys, equal results. Empty if there is no result.
using StageKeys = std::array<std::string, kStageCount>;

} // namespace voluta::project
