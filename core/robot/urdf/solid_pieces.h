// Approximates a mesh by a few simple solids, for obstacles given as files.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "robot/body.h"

#include <vector>

namespace voluta::robot {

// Returns up to `maxPieces` boxes, cylinders and capsules that together contain every triangle of
// the mesh, and the inside of a closed one; they also contain some space around it. In the mesh's
// frame [mm].
//
// A component enclosed by one solid of at most 1.1 times its volume becomes that solid. The rest is
// cut into cubes, eight along its longest side, whose contents are boxed. Neighbours are joined,
// those first whose common box adds the least volume, as long as all joins together add no more
// than a fiftieth of the whole box, or more than `maxPieces` pieces are left (approximate convex
// decomposition from below, as Mamou and Ghorbel 2009 join clusters). This is done along the
// coordinate axes and along the principal axes, and the result with the smaller sum is used; each
// piece becomes the smallest solid around its points. Flat pieces are a millimetre thick. Throws
// Cancelled. Preconditions: triangles with finite corners, not all in one point; maxPieces >= 1.
std::vector<Shape> solidPieces(const geometry::TriangleMesh& mesh, int maxPieces,
                               const base::RunContext& ctx);

} // namespace voluta::robot
