// Built-in parts for printing on a body (Castelli 2020, 5.2.1 and 5.2.2, table 5.1): a rib on a
// gable roof and one on a half cylinder, each with its body in the same frame. Closed meshes with
// outward normals, computed by formula; ridge and cylinder lie along x, the bodies on z = 0.
#pragma once

#include "geometry/triangle_mesh.h"

namespace voluta::project {

// Returns a prism 30 mm long whose section is an equilateral triangle of 40 mm.
geometry::TriangleMesh gableRoof();
// Returns ten layers over both slopes, ten beads wide (6.57 mm), rounded over the ridge, from 8 mm
// above z = 0: the nozzle tilts up to 60 degrees.
geometry::TriangleMesh ribOnRoof();
// Returns the upper half of a cylinder of 40 mm, 30 mm long.
geometry::TriangleMesh halfCylinder();
// Returns the same layers around it, from 1.1 mm above z = 0: the nozzle tilts up to 87 degrees.
geometry::TriangleMesh ribOnCylinder();

} // namespace voluta::project
