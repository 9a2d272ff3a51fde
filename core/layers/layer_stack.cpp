#include "layers/layer_stack.h"

#include <utility>

namespace voluta::layers {

std::shared_ptr<LayerStack> kept(LayerStack stack) {
  stack.patches.shrink_to_fit();
  for (Patch& patch : stack.patches) {
    patch.surface.vertices.shrink_to_fit();
    patch.surface.triangles.shrink_to_fit();
    patch.thicknessMm.shrink_to_fit();
    patch.direction.shrink_to_fit();
    patch.clearDirection.shrink_to_fit();
    patch.innerRim.shrink_to_fit();
    patch.chart.at.shrink_to_fit();
  }
  return std::make_shared<LayerStack>(std::move(stack));
}

} // namespace voluta::layers
