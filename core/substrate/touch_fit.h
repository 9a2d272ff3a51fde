// Where a real substrate is, from points that were touched on it.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace voluta::substrate {

struct CircleFit {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radiusMm = 0.0;
  double rmsMm = 0.0; // distance of the points from it; 0 to rounding for three
};

// The circle through three points, or the one of least squares of the same equations through more
// (Castelli 2020, eq. 5.1-5.3): rows [y z 1] [A B C]^T = -(y^2 + z^2). mm. Throws
// Error{UnusableInput} for fewer than three points, points on a line, or numbers that are not
// finite.
CircleFit circleThrough(const std::vector<Eigen::Vector2d>& points);

} // namespace voluta::substrate
