// The convex front as a surface, for display.
#pragma once

#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"

#include <cstdint>

namespace voluta::curved {

// Returns the hull of the platform and the centres of all voxels (supports included) of rank 1 to
// `rank` [mm], closed and facing outward: voxels of the next rank must not be inside this front
// (dissertation 3.4.1). Corners of the platform are rounded to a sixteenth of a cell, as in growth.
// Empty if nothing is printed yet. Precondition (Error{Internal}): one rank per cell, a platform of
// three corners or more.
geometry::TriangleMesh frontSurface(const Decomposition& decomposition, std::int32_t rank);

} // namespace voluta::curved
