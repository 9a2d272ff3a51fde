// Writes voxels.vti for other programs (ParaView), without VTK.
#pragma once

#include "curved/decomposition.h"

#include <string>

namespace voluta::curved {

// VTK XML ImageData: cell data `rank` (0 outside, n >= 1 the layer, -1 missed), `kind` (0 part, 1
// support), `byHead` (1: deeper inside the front, reached by the head itself) and, if available,
// `field` (mm, NaN outside); field data `platform` (x, y of the polygon's corners) and `epsilon`
// (depth in mm to which a voxel may be inside the front). Raw appended little-endian arrays.
std::string voxelsVti(const Decomposition& decomposition);

} // namespace voluta::curved
