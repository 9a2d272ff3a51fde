// The order in which patches are laid.
#pragma once

#include "layers/layer_stack.h"

namespace voluta::layers {

// From below by Patch::layer, so that a patch comes after what supports it; within a layer each
// patch is followed by the nearest one left (centroids), the first being nearest to the last of the
// layer before, or to the origin. Stable: ties go to the patch that came first. Layers are numbered
// anew from 0 without gaps; layerCount is set.
void orderForPrinting(LayerStack& stack);

// Layers from 0 without gaps where patches are in print order already; sets layerCount.
void numberLayers(LayerStack& stack);

} // namespace voluta::layers
