// The volume of layers, measured apart from layers::layerStatistics.
#pragma once

#include "layers/layer_stack.h"

#include <cstddef>

namespace voluta::test {

// Sum of triangle areas times mean thickness.
inline double volumeOf(const layers::LayerStack& stack) {
  double sum = 0.0;
  for (const layers::Patch& p : stack.patches)
    for (std::size_t t = 0; t < p.surface.triangles.size(); ++t) {
      const Eigen::Vector3d a = p.surface.corner(t, 1) - p.surface.corner(t, 0),
                            b = p.surface.corner(t, 2) - p.surface.corner(t, 0);
      double thickness = 0.0;
      for (int v : p.surface.triangles[t])
        thickness += p.thicknessMm[static_cast<std::size_t>(v)] / 3.0;
      sum += 0.5 * a.cross(b).norm() * thickness;
    }
  return sum;
}

} // namespace voluta::test
