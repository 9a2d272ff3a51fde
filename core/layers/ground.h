// The ground below the first layer.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace voluta::layers {

struct Ground {
  // Returns the distance of a point from the ground [mm], negative inside. Empty: the plate z = 0.
  // Must be thread-safe.
  std::function<double(const Eigen::Vector3d&)> heightMm = {};

  double over(const Eigen::Vector3d& p) const { return heightMm ? heightMm(p) : p.z(); }
};

} // namespace voluta::layers
