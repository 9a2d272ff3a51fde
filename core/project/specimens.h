// Built-in parts for reinforcing with tapes (Dai 5.4): closed meshes with outward normals, computed
// by formula.
#pragma once

#include "geometry/triangle_mesh.h"

namespace voluta::project {

// Returns a bar for bending, 250 x 10 x 5 mm.
geometry::TriangleMesh barSpecimen();
// Returns a dumb-bell for tension, 165 x 19 x 3 mm, 13 mm wide in the middle (ASTM D638, type I).
geometry::TriangleMesh dumbbellSpecimen();
// Returns a plate of 120 x 60 x 3 mm with a hole of 20 mm in its middle.
geometry::TriangleMesh plateSpecimen();
// Returns a bar bent around a cylinder along y: 75 degrees at a radius of 60 mm, 10 mm wide, seven
// layers of 0.6 mm; symmetric about x = 0, the cylinder's axis is y. `facetDeg`: about how far a
// facet turns around the axis.
geometry::TriangleMesh curvedSpecimen(double facetDeg = 0.25);
// Returns the mould under it, in the same frame: a block 20 mm wide with a cylindrical top of 80
// degrees.
geometry::TriangleMesh mouldOfCurvedSpecimen(double facetDeg = 0.25);

} // namespace voluta::project
