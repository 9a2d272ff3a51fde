// Export of layers in VTK's XML format for polygons, for viewing in other programs.
#pragma once

#include "layers/layer_stack.h"

#include <string>

namespace voluta::layers {

// Returns the bytes of layers.vtp: all patches as triangles; point data `thickness` (mm),
// `direction`; cell data `layer`, `group`, `patch`. Uses base/vtk_xml.h.
std::string writeLayersVtp(const LayerStack& stack);

} // namespace voluta::layers
