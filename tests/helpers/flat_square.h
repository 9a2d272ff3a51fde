// A level surface in closed form.
#pragma once

#include "layers/level_surface.h"

#include <cmath>

namespace voluta::test {

// A flat grid of triangles at height z over [-half, half]^2, upright, of one thickness; where the
// step does not divide the square the grid overhangs at the far sides. mm, step > 0.
inline layers::LevelSurface flatSquare(double half, double step, double z, double thickness = 0.8) {
  layers::LevelSurface s;
  const int n = static_cast<int>(std::ceil(2 * half / step - 1e-9));
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      s.surface.vertices.emplace_back(-half + i * step, -half + j * step, z);
      s.thicknessMm.push_back(thickness);
      s.direction.push_back(Eigen::Vector3d::UnitZ());
      s.clearDirection.push_back(Eigen::Vector3d::UnitZ());
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = i + (n + 1) * j, b = a + 1, c = a + n + 1, d = c + 1;
      s.surface.triangles.push_back({a, b, d});
      s.surface.triangles.push_back({a, d, c});
    }
  return s;
}

} // namespace voluta::test
