// Places for pins in the section of a part.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/plane.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

struct PinRoom {
  double radiusMm = 0.0; // of the hole
  double depthMm = 0.0;  // of the hole, to either side of the plane
  double wallMm = 0.0;   // around the hole
  int count = 1;         // in each outline of the section
};

// Returns points on the plane around which holes leave walls: far from each other, in the order of
// the outlines' size. `section`: its triangles, on the plane. Empty: there is no room for any.
std::vector<Eigen::Vector3d> pinPlaces(const geometry::TriangleMesh& part,
                                       const geometry::TriangleMesh& section, const Plane& plane,
                                       const PinRoom& room);

} // namespace voluta::planar
