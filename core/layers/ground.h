// What the first layer lies on.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace voluta::layers {

struct Ground {
  // Distance of a point from the ground, mm, negative inside. Empty: the plate z = 0. Called from
  // many threads at once.
  std::function<double(const Eigen::Vector3d&)> heightMm = {};

  double over(const Eigen::Vector3d& p) const { return heightMm ? heightMm(p) : p.z(); }
};

} // namespace voluta::layers
