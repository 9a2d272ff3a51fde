// Triangulation of a planar region given by its boundary.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace voluta::layers {

// Returns a constrained Delaunay triangulation of the region inside the `edges` (index pairs into
// `points`, in any direction and order). A triangle is inside if a path to it from infinity crosses
// an odd number of edges, so loops may be nested, and edges that occur twice cancel. Adds no
// points. The index triples are counter-clockwise, in an order that depends only on the input.
// Returns nullopt if edges cross or points of edges coincide. Points that no edge uses are ignored.
std::optional<std::vector<std::array<int, 3>>>
fillRegion(const std::vector<Eigen::Vector2d>& points,
           const std::vector<std::array<int, 2>>& edges);

} // namespace voluta::layers
