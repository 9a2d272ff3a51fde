// Layers for other programs to look at (VTK's XML format for polygons).
#pragma once

#include "layers/layer_stack.h"

#include <string>

namespace voluta::layers {

// The bytes of layers.vtp: all patches as triangles; point data `thickness` (mm), `direction`; cell
// data `layer`, `group`, `patch`. Arrays are base64 of little-endian Float32 / Int32.
std::string writeLayersVtp(const LayerStack& stack);

} // namespace voluta::layers
