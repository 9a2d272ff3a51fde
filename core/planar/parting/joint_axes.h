// Axes in the plane of a cut.
#pragma once

#include "planar/plane.h"

namespace voluta::planar {

// Returns the frame of a plane whose first axis is horizontal.
inline PlaneFrame jointAxes(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d level = Eigen::Vector3d::UnitZ().cross(normal);
  const Eigen::Vector3d across =
      level.norm() > 1e-6 ? level.normalized() : Eigen::Vector3d::UnitX();
  return {across, normal.cross(across)};
}

} // namespace voluta::planar
