// Loose triangles cut by a plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::robot {

using Corners = std::array<Eigen::Vector3d, 3>;

// Where normal . p = offset.
struct Plane {
  Eigen::Vector3d normal;
  double offset;
};

// What is below the plane and what is above; triangles across it are cut. What lies in it is below.
std::array<std::vector<Corners>, 2> cut(const std::vector<Corners>& triangles, const Plane& plane);

} // namespace voluta::robot
