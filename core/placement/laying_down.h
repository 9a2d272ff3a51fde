// Lays a part down in the block that it is milled out of (Castelli 2020, 7.2.4).
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>

namespace voluta::placement {

struct MillingOrientation {
  // Relative to the mesh's present orientation
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  int rounds = 0; // of the second step
  // Volume of the bounding box less the part's [mm3]
  double scrapBeforeMm3 = 0.0, scrapMm3 = 0.0;
};

// Returns the orientation for a cutter that comes along z and whose lines are along x, in the
// source's three steps (its axes y and z are z and y here):
//   1. orienting: three times, the part turns about y, z and x by the slope of the regression line
//      through the middles of its projection's sections;
//   2. laying down: the part turns so that the least rectangles around its projections on xy and yz
//      are parallel to the axes, until they are within 0.01 degrees, at most 10 times. Not in the
//      source: the same on all three planes; the same from the principal axes of its convex hull's
//      corners, if the bounding box is smaller then; and quarter turns that bring the box's least
//      side along z and the greatest along x;
//   3. least residual areas: minResidualRotation(), on xz and then on xy.
// If the bounding box is not smaller then, only quarter turns are made. Preconditions as
// outlineArea().
MillingOrientation millingOrientation(const geometry::TriangleMesh& part);

} // namespace voluta::placement
