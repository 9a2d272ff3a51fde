// The first layer: the patches and beads that lie on the platform.
#pragma once

#include "layers/layer_stack.h"
#include "platform/platform_solid.h"

#include <cstddef>
#include <vector>

namespace voluta::toolpath {

// Returns the height of the patch's underside over the plate at a vertex [mm].
double undersideOf(const layers::Patch& patch, std::size_t vertex);

// Returns whether the patch's underside touches the plate at a vertex, to a quarter of its
// thickness.
bool touchesPlate(const layers::Patch& patch, std::size_t vertex);

// Returns per patch 1 if it is of level 0 or, on a plate, if all of its underside touches the plate
// (pieces and items that begin at a later level).
std::vector<char> firstLayerPatches(const layers::LayerStack& stack,
                                    const platform::PlatformSolid& platform);

} // namespace voluta::toolpath
