// Fits a real substrate to points that were touched on it.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace voluta::substrate {

struct CircleFit {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radiusMm = 0.0;
  // RMS distance of the points from the circle; 0 up to rounding for three points
  double rmsMm = 0.0;
};

// Returns the circle through three points, or the least-squares fit of the same equations to more
// (Castelli 2020, eq. 5.1-5.3): rows [y z 1] [A B C]^T = -(y^2 + z^2) [mm]. Throws
// Error{UnusableInput} for fewer than three points, collinear points, or NaN or infinite
// coordinates.
CircleFit circleThrough(const std::vector<Eigen::Vector2d>& points);

} // namespace voluta::substrate
