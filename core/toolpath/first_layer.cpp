#include "toolpath/first_layer.h"

namespace voluta::toolpath {

double undersideOf(const layers::Patch& patch, std::size_t vertex) {
  return patch.surface.vertices[vertex].z() -
         0.5 * patch.thicknessMm[vertex] * patch.direction[vertex].z();
}

bool touchesPlate(const layers::Patch& patch, std::size_t vertex) {
  constexpr double kTouching = 0.25; // of the thickness
  return undersideOf(patch, vertex) <= kTouching * patch.thicknessMm[vertex];
}

std::vector<char> firstLayerPatches(const layers::LayerStack& stack,
                                    const platform::PlatformSolid& platform) {
  const bool onPlate = platform.polygon.size() >= 3 && !platform.mesh && !platform.rod;
  const auto isFirst = [&](const layers::Patch& patch) {
    if (patch.layer == 0)
      return true;
    if (!onPlate || patch.surface.vertices.empty())
      return false;
    for (std::size_t v = 0; v < patch.surface.vertices.size(); ++v)
      if (!touchesPlate(patch, v))
        return false;
    return true;
  };
  std::vector<char> first;
  for (const layers::Patch& patch : stack.patches)
    first.push_back(isFirst(patch) ? 1 : 0);
  return first;
}

} // namespace voluta::toolpath
