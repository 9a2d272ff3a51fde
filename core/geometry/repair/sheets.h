// Separates surfaces without thickness from solids.
#pragma once

#include "geometry/triangle_mesh.h"

namespace voluta::geometry {

struct SolidsAndSheets {
  TriangleMesh solids; // closed components that enclose a volume
  TriangleMesh sheets; // all others; closed ones without volume are sheets with two sides
};
SolidsAndSheets separateSolids(const TriangleMesh& mesh);

} // namespace voluta::geometry
