// What modes whose layers follow a ground have in common.
#pragma once

#include "modes/mode.h"
#include "substrate/level_stack.h"
#include "substrate/overhang.h"

#include <memory>
#include <string>

namespace voluta::modes {

// Heights, bead and firstLayerMm. Throws Error{Usage} for a first layer that the process cannot
// lay.
substrate::LevelOptions levelOptions(const ModeChoices& in);
std::string levelText(const ModeChoices& in);
substrate::OverhangRule overhangRule(const ModeChoices& in);

// Nothing: all that goes into such layers decided already how many there are.
std::string levelLayersKey(const ModeChoices&);

// Puts a decomposition into so many layers, and what of the part leans out over them, into the
// stage's report and findings.
void tellLevels(const ModeChoices& in, int layers, const substrate::Overhang& overhang,
                substrate::GroundKind ground, DecomposeStage& stage);

std::shared_ptr<const LayersStage> layersStage(substrate::StackedLevels stacked, double seconds);

} // namespace voluta::modes
