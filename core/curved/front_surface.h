// The convex front as a surface, for pictures.
#pragma once

#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"

#include <cstdint>

namespace voluta::curved {

// The hull of the platform and the centres of all voxels (support too) of rank 1 to `rank`, mm,
// closed and facing outward: the front that voxels of the next rank must not lie inside
// (dissertation 3.4.1). Corners of the platform are rounded to a sixteenth of a cell, as in growth.
// Empty where nothing is laid yet. Precondition (Error{Internal}): one rank a cell, a platform of
// three corners or more.
geometry::TriangleMesh frontSurface(const Decomposition& decomposition, std::int32_t rank);

} // namespace voluta::curved
