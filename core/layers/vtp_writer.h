// Layers for other programs to look at (VTK's XML format for polygons).
#pragma once

#include "layers/layer_stack.h"

#include <string>

namespace voluta::layers {

// The bytes of layers.vtp: all patches as triangles; point data `thickness` (mm), `direction`; cell
// data `layer`, `group`, `patch`. Written by base/vtk_xml.h.
std::string writeLayersVtp(const LayerStack& stack);

} // namespace voluta::layers
