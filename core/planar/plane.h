// An oriented plane.
#pragma once

#include <Eigen/Geometry>

namespace voluta::planar {

// normal . x = offsetMm; the normal points to the side above.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); // unit
  double offsetMm = 0.0;

  double heightOf(const Eigen::Vector3d& p) const { return normal.dot(p) - offsetMm; }
};

// Two unit vectors that form a right-handed frame with the unit normal: across, along, normal.
struct PlaneFrame {
  Eigen::Vector3d across, along;
};
inline PlaneFrame frameOf(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d across = normal.unitOrthogonal();
  return {across, normal.cross(across)};
}

} // namespace voluta::planar
