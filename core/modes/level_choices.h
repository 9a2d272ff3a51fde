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
substrate::OverhangRule overhangRule(const ModeChoices& in);

// Puts a decomposition into so many layers, and what of the part leans out over them, into the
// stage's report and findings.
void tellLevels(const substrate::OverhangRule& rule, int layers,
                const substrate::Overhang& overhang, substrate::GroundKind ground,
                DecomposeStage& stage);

std::shared_ptr<const LayersStage> layersStage(substrate::StackedLevels stacked, double seconds);

} // namespace voluta::modes
