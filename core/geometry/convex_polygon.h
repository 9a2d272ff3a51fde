// Convex polygons in the plane: hulls of points, and what is in them.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voluta::geometry {

// Corners counter-clockwise, without corners on its sides (to 1e-9 of twice a triangle's area).
// Of fewer than three points that are not in line, at most two of them. Widened by marginMm >= 0.
std::vector<Eigen::Vector2d> convexPolygon(std::vector<Eigen::Vector2d> points,
                                           double marginMm = 0.0);

// Is the point in the polygon (convex, counter-clockwise) or on its sides? Not in one without
// corners.
bool inConvexPolygon(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point);

} // namespace voluta::geometry
