// Triangulation of a small polygon in the plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::layers {

// Clips ears off a simple, counter-clockwise polygon, best-shaped first (O(n^3): for few corners).
// Corners on a straight side are allowed. Returns index triples, counter-clockwise. A polygon that
// crosses itself gives a filling that uses each side once, with some triangles inverted.
std::vector<std::array<int, 3>> fillPolygon(const std::vector<Eigen::Vector2d>& corners);

} // namespace voluta::layers
