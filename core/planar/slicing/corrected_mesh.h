// A part whose sizes are corrected as those of its flat layers.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/slicing/size_correction.h"

namespace voluta::planar {

// Returns the mesh with the sections that corrected() gives, as far as its vertices allow: scaled
// about the middle of its bounding box, walls moved by the offset of the contour that they belong
// to. Details narrower than twice an offset may fold. Precondition: closed, facing outward.
geometry::TriangleMesh correctedMesh(const geometry::TriangleMesh& mesh,
                                     const SizeCorrection& correction);

} // namespace voluta::planar
