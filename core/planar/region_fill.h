// Triangles that fill a region of the plane, given by its boundary.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace voluta::planar {

// Constrained Delaunay triangulation of the region inside the `edges` (index pairs into `points`,
// in any direction and order): a triangle belongs to it when a way to it from far off crosses an
// odd number of edges. So loops may lie in one another, and edges that occur twice cancel. Adds no
// point. Counter-clockwise index triples, in an order that depends only on the input. Nothing where
// edges cross or points of edges coincide. Points that no edge uses are left out.
std::optional<std::vector<std::array<int, 3>>>
fillRegion(const std::vector<Eigen::Vector2d>& points,
           const std::vector<std::array<int, 2>>& edges);

} // namespace voluta::planar
