// Triangulation of the polygons in mesh files.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::geometry {

// Returns corner indices (into `polygon`) of size - 2 triangles, by ear clipping in the coordinate
// plane of smallest distortion; a polygon without a further ear (self-crossing) is finished as a
// fan. Precondition: at least 3 corners. O(n^2) to O(n^3).
std::vector<std::array<std::size_t, 3>>
triangulatePolygon(const std::vector<Eigen::Vector3d>& polygon);

} // namespace voluta::geometry
