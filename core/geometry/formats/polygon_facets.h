// Polygons of mesh files as triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::geometry {

// Corner indices (into `polygon`) of size - 2 triangles, by cutting ears in the plane of least
// distortion; a polygon that has no ear left (crossing itself) is finished as a fan.
// Precondition: 3 corners or more. O(n^2) to O(n^3).
std::vector<std::array<std::size_t, 3>>
triangulatePolygon(const std::vector<Eigen::Vector3d>& polygon);

} // namespace voluta::geometry
