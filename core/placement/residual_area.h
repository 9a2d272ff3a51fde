// Residual areas of a part's projections, and the rotation that minimizes them.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <vector>

namespace voluta::placement {

// A plane of projection: the unit vectors of its two axes, in rows.
using ProjectionPlane = Eigen::Matrix<double, 2, 3>;
ProjectionPlane xyPlane();
ProjectionPlane xzPlane();

// Returns the area enclosed by the outline of the mesh's projection (Gauss' formula); holes count
// as enclosed [mm2]. Precondition: the mesh is closed and faces outward.
double outlineArea(const geometry::TriangleMesh& mesh, const ProjectionPlane& plane);

// Returns the area of the bounding rectangle, parallel to the axes, of points that are rotated
// counter-clockwise by `angleRad` about the origin [mm2].
double rectangleArea(const std::vector<Eigen::Vector2d>& points, double angleRad);

// Bounding rectangles less outlines [mm2].
struct ResidualAreas {
  double xyMm2 = 0.0, xzMm2 = 0.0;
};
ResidualAreas residualAreas(const geometry::TriangleMesh& mesh, const Eigen::Matrix3d& rotation);

struct ResidualRotation {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  ResidualAreas before, after;
  std::size_t tried = 0; // number of angles compared
};

// Returns the rotation with the least residual areas (Castelli 2020, 4.2): about z by steps of 1
// degree over 180 degrees for the least residual area on XY, then about y for that on XZ; the best
// angles are refined by steps of 0.1 and 0.01 degrees. About y only if allowed(rotation) returns
// true. An angle of 0 is kept unless the bounding rectangle shrinks by more than 0.2 %; of equal
// angles the smallest is taken. quarterTurns: only angles of 0 and 90 degrees. Preconditions as
// outlineArea().
ResidualRotation minResidualRotation(const geometry::TriangleMesh& mesh, bool quarterTurns,
                                     const std::function<bool(const Eigen::Matrix3d&)>& allowed);

} // namespace voluta::placement
