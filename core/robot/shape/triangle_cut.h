// Cuts a set of triangles by a plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::robot {

using Corners = std::array<Eigen::Vector3d, 3>;

// Points with normal . p = offset.
struct Plane {
  Eigen::Vector3d normal;
  double offset;
};

// Returns the triangles below and above the plane; triangles that cross it are cut. Triangles in
// the plane count as below.
std::array<std::vector<Corners>, 2> cut(const std::vector<Corners>& triangles, const Plane& plane);

} // namespace voluta::robot
