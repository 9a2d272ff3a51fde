// A level at constant radius in closed form.
#pragma once

#include "base/units.h"
#include "layers/level_surface.h"

#include <algorithm>
#include <cmath>

namespace voluta::test {

// Closed around the x axis between two places of it, triangles of about `edgeMm`, with the chart
// u = radius * angle from +y towards +z, v = x. mm, all > 0 but the places.
inline layers::LevelSurface rodLevel(double radius, double x0, double x1, double edgeMm,
                                     double thickness) {
  constexpr double pi = base::kPi;
  layers::LevelSurface s;
  const int around = std::max(90, static_cast<int>(std::ceil(2 * pi * radius / edgeMm))),
            along = std::max(1, static_cast<int>(std::ceil((x1 - x0) / edgeMm)));
  s.chart.periodMm = 2 * pi * radius;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double a = 2 * pi * (i + 0.5 * (j % 2)) / around - pi, x = x0 + (x1 - x0) * j / along;
      const Eigen::Vector3d d(0, std::cos(a), std::sin(a));
      s.surface.vertices.push_back(radius * d + x * Eigen::Vector3d::UnitX());
      s.thicknessMm.push_back(thickness);
      s.direction.push_back(d);
      s.clearDirection.push_back(d);
      s.chart.at.emplace_back(radius * a, x);
    }
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const int k = (i + 1) % around, a = j * around + i, b = j * around + k;
      const int c = a + around, d = b + around;
      if (j % 2 == 0) {
        s.surface.triangles.push_back({a, b, c});
        s.surface.triangles.push_back({b, d, c});
      } else {
        s.surface.triangles.push_back({a, d, c});
        s.surface.triangles.push_back({a, b, d});
      }
    }
  return s;
}

} // namespace voluta::test
