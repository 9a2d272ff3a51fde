// The point of a segment that is nearest to a point.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace voluta::geometry {

// Returns the share of the length from a to b at which the segment is nearest to p, 0 to 1; 0 if a
// and b are equal.
template <int kDimensions>
double nearestShare(const Eigen::Vector<double, kDimensions>& p,
                    const Eigen::Vector<double, kDimensions>& a,
                    const Eigen::Vector<double, kDimensions>& b) {
  const Eigen::Vector<double, kDimensions> along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
}

} // namespace voluta::geometry
