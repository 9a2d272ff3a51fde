// The convex hull of points in the plane.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voluta::geometry {

// Corners counter-clockwise, without corners on its sides (to 1e-9 of twice a triangle's area).
// Of fewer than three points that are not in line, at most two of them. Widened by marginMm >= 0.
std::vector<Eigen::Vector2d> convexPolygon(std::vector<Eigen::Vector2d> points,
                                           double marginMm = 0.0);

} // namespace voluta::geometry
