// The axis that a part is wound about.
#pragma once

#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>

namespace voluta::substrate {

struct AxisFit {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();      // on the axis, beside the area's centre
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); // unit, its largest coordinate positive
  double sharpness = 1.0; // how much more normals vary across it than along it; >= 1 where fitted
};

// Direction: the one along which the facets' normals, weighted by area, vary least; where two are
// alike, as across a disc, the one along which they vary most. Point: the one
// that the facets' normals pass nearest to (least squares of n . (a x (q - p)) over facets of
// centre q). Throws Error{UnusableInput} where no direction is 1.5 times clearer than the next (a
// cube, a sphere) and for a mesh without area.
AxisFit fitAxis(const geometry::TriangleMesh& mesh);

// Of the same point, where the direction is given. Precondition: not zero. Throws
// Error{UnusableInput} for a mesh without area.
AxisFit axisAlong(const geometry::TriangleMesh& mesh, const Eigen::Vector3d& direction);

// Lays the part's axis on the x axis of the work frame, the middle of its length at x = 0, turned
// by the shortest way. For geometry::place with the same scale.
geometry::Placement placementOnAxis(const geometry::TriangleMesh& mesh, double scale,
                                    const AxisFit& axis);

} // namespace voluta::substrate
