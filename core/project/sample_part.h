// The part that Voluta brings along.
#pragma once

#include "geometry/triangle_mesh.h"

namespace voluta::project {

// A fluted vase, 60 mm high and about 45 mm wide, solid, that leans over its foot: its sides hang
// over by up to about 40 degrees, so that curved layers serve it. Closed, outward, flat base on z =
// 0, about 13,000 triangles. Made by formula, the same on every call.
geometry::TriangleMesh samplePart();

} // namespace voluta::project
