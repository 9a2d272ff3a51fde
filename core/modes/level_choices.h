// Options and report shared by the modes whose layers follow a ground surface (lathe, substrate),
// and the first layer of all modes that have layers of given heights.
#pragma once

#include "modes/mode.h"
#include "substrate/level_stack.h"
#include "substrate/overhang.h"

#include <memory>
#include <string>

namespace voluta::modes {

// Returns the height of the first layer [mm]; 0: as the others. Throws Error{Usage} if it is
// outside the process's limits.
double firstLayerMm(const ModeChoices& in);
// Returns layer heights, bead width and firstLayerMm. Throws Error{Usage} if the first layer is
// outside the process's limits.
substrate::LevelOptions levelOptions(const ModeChoices& in);
substrate::OverhangRule overhangRule(const ModeChoices& in);

// Adds the number of layers and the part's overhang over the ground to the stage's report and
// findings.
void reportLevels(const substrate::OverhangRule& rule, int layers,
                  const substrate::Overhang& overhang, substrate::GroundKind ground,
                  DecomposeStage& stage);

std::shared_ptr<const LayersStage> layersStage(substrate::StackedLevels stacked, double seconds);

} // namespace voluta::modes
