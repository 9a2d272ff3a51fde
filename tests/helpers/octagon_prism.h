// Parts drawn in one section.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <array>

namespace voluta::test {

// An octagon of x and z, cut into triangles, `half` deep to either side along y. mm, closed,
// outward where the octagon runs counter-clockwise seen along +y.
inline geometry::TriangleMesh octagonPrism(const std::array<Eigen::Vector2d, 8>& outline,
                                           const std::array<std::array<int, 3>, 6>& triangles,
                                           double half) {
  geometry::TriangleMesh m;
  for (const double y : {-half, half})
    for (const Eigen::Vector2d& p : outline)
      m.vertices.emplace_back(p.x(), y, p.y());
  for (const auto& t : triangles) {
    m.triangles.push_back(t);
    m.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  }
  for (int i = 0; i < 8; ++i) {
    const int j = (i + 1) % 8;
    m.triangles.push_back({i, i + 8, j + 8});
    m.triangles.push_back({i, j + 8, j});
  }
  return m;
}

// A leg, 8 square and as high as given, with a bar 8 deep and 8 high across its top.
inline geometry::TriangleMesh tee(double legMm, double barMm) {
  const double half = 0.5 * barMm, top = legMm + 8;
  return octagonPrism({{{-4, 0},
                        {4, 0},
                        {4, legMm},
                        {half, legMm},
                        {half, top},
                        {-half, top},
                        {-half, legMm},
                        {-4, legMm}}},
                      {{{0, 1, 2}, {0, 2, 7}, {2, 3, 4}, {2, 4, 7}, {7, 4, 5}, {7, 5, 6}}}, 4);
}

} // namespace voluta::test
