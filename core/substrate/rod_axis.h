// Finds the axis around which a part is wound.
#pragma once

#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>

namespace voluta::substrate {

struct AxisFit {
  // On the axis, at the surface's centroid along it
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  // Unit vector with a positive largest coordinate
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  // How much more normals vary across the axis than along it; >= 1 if fitted
  double sharpness = 1.0;
};

// Fits the axis. Direction: the one along which the facets' normals, weighted by area, vary least;
// if two are alike, as for a disc, the one along which they vary most. Point: the one that the
// facets' normals pass nearest to (least squares of n . (a x (q - p)) over facets with centroid q).
// Throws Error{UnusableInput} if no direction is 1.5 times clearer than the next (a cube, a
// sphere), and for a mesh without area.
AxisFit fitAxis(const geometry::TriangleMesh& mesh);

// Fits only the point for a given direction. Precondition: direction is not zero. Throws
// Error{UnusableInput} for a mesh without area.
AxisFit axisAlong(const geometry::TriangleMesh& mesh, const Eigen::Vector3d& direction);

// Returns the placement that puts the part's axis on the x axis of the work frame, with the middle
// of its length at x = 0, by the smallest rotation. For geometry::place with the same scale.
geometry::Placement placementOnAxis(const geometry::TriangleMesh& mesh, double scale,
                                    const AxisFit& axis);

} // namespace voluta::substrate
