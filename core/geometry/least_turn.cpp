#include "geometry/least_turn.h"

#include <cmath>

namespace voluta::geometry {

// Implemented here because Eigen's version pulls a singular value decomposition into every build.
Eigen::Quaterniond shortestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = a.dot(b);
  constexpr double kOpposite = -1.0 + 1e-12; // their cross product gives no axis
  if (cosine < kOpposite) {
    const Eigen::Vector3d axis = a.unitOrthogonal();
    return {0.0, axis.x(), axis.y(), axis.z()};
  }
  const double twice = std::sqrt(2.0 * (1.0 + cosine)); // 2 cos of half the angle
  const Eigen::Vector3d axis = a.cross(b) / twice;
  return Eigen::Quaterniond(0.5 * twice, axis.x(), axis.y(), axis.z()).normalized();
}

} // namespace voluta::geometry
