// What modes whose layers follow a ground have in common.
#pragma once

#include "pipeline/modes.h"
#include "substrate/level_stack.h"
#include "substrate/overhang.h"

#include <memory>
#include <string>

namespace voluta::pipeline {

// Heights, bead and firstLayerMm. Throws Error{Usage} for a first layer that the process cannot
// lay.
substrate::LevelOptions levelOptions(const ModeChoices& in);
std::string levelText(const ModeChoices& in);
substrate::OverhangRule overhangRule(const ModeChoices& in);

std::shared_ptr<const LayersStage> layersStage(substrate::StackedLevels stacked, double seconds);

} // namespace voluta::pipeline
