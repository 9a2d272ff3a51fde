// The built-in sample part.
#pragma once

#include "geometry/triangle_mesh.h"

namespace voluta::project {

// Returns a solid fluted vase, 60 mm high and about 45 mm wide, that leans over its foot: its sides
// overhang by up to about 40 degrees, so that it benefits from curved layers. Closed mesh with
// outward normals, flat base on z = 0, about 13,000 triangles. Computed by formula; the same on
// every call.
geometry::TriangleMesh samplePart();

} // namespace voluta::project
