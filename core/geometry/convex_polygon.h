// Convex polygons in the plane: convex hulls and point containment.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voluta::geometry {

// Returns the convex hull, counter-clockwise, without vertices on its sides (to 1e-9 of twice a
// triangle's area), widened by marginMm >= 0. Returns at most two points if the input has fewer
// than three that are not collinear.
std::vector<Eigen::Vector2d> convexPolygon(std::vector<Eigen::Vector2d> points,
                                           double marginMm = 0.0);

// Returns whether the point is in the polygon (convex, counter-clockwise) or on its sides; false
// for an empty polygon.
bool inConvexPolygon(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point);

} // namespace voluta::geometry
