// Triangles that fill a small polygon in the plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::layers {

// Cuts ears off a simple polygon, counter-clockwise, best-shaped first (O(n^3): for a few corners).
// Corners on a straight side are allowed. Returns index triples, counter-clockwise; a polygon that
// crosses itself gives a filling that uses each side once, some triangles then being turned over.
std::vector<std::array<int, 3>> fillPolygon(const std::vector<Eigen::Vector2d>& corners);

} // namespace voluta::layers
