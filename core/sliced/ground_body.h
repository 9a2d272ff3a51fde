// The body below tool-paths that are not printed on the plate.
#pragma once

#include "geometry/triangle_mesh.h"
#include "sliced/curved_ground.h"

#include <Eigen/Geometry>

namespace voluta::sliced {

// Returns a block whose top is the ground: 10 mm larger than a level part with that box, 5 mm thick
// where it is thinnest, with a level bottom. Its centre is on the z axis if that of the box is.
// Closed, facing outward; within 0.01 mm of the ground. Precondition: a ground other than the
// plate; the part reaches no farther than 90 degrees from its top.
geometry::TriangleMesh groundBody(const CurvedGround& ground, const Eigen::AlignedBox3d& part);

} // namespace voluta::sliced
