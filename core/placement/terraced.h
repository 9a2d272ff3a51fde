// Parts that flat layers print as well as any others.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>

namespace voluta::placement {

// Returns whether the part, rotated by `rotation`, has horizontal and vertical faces only, and none
// that faces down above its lowest point: flat layers need no support and make no staircase.
// Precondition: mesh not empty.
bool isTerraced(const geometry::TriangleMesh& mesh, const Eigen::Matrix3d& rotation);

} // namespace voluta::placement
