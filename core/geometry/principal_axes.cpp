#include "geometry/principal_axes.h"

#include "base/error.h"
#include "geometry/symmetric_axes.h"

namespace voluta::geometry {

using Eigen::Vector3d;

Eigen::Matrix3d principalAxes(const std::vector<Vector3d>& points) {
  base::require(!points.empty(), "points that are spread");
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : points)
    middle += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points)
    spread += (p - middle) * (p - middle).transpose();
  return symmetricAxes(spread).axes;
}

} // namespace voluta::geometry
