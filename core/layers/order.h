// Print order of patches.
#pragma once

#include "layers/layer_stack.h"

namespace voluta::layers {

// Sorts patches by Patch::layer, so that each comes after those that support it. Within a layer the
// next patch is always the nearest remaining one (by centroids), the first being the nearest to the
// last patch of the preceding layer, or to the origin. Stable: ties keep their order. Layers are
// renumbered from 0 without gaps; layerCount is set.
void orderForPrinting(LayerStack& stack);

// Renumbers the layers of patches already in print order, from 0 without gaps; sets layerCount.
void numberLayers(LayerStack& stack);

} // namespace voluta::layers
