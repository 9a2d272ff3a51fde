// A mesh as a few simple solids, for obstacles that come as files.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "robot/body.h"

#include <vector>

namespace voluta::robot {

// Up to `most` boxes, cylinders and capsules that hold, between them, every triangle of the mesh
// and the inside of a closed one; what they hold beside it is what simple solids cost. In the
// mesh's frame, mm.
//
// A component that one solid fits, holding a tenth more than the component at most, is that solid.
// The rest is cut into cubes, eight along its longest side; what each holds is boxed, and
// neighbours are joined, those first whose common box adds least, as long as all joints add no more
// than a fiftieth of the whole box, or more are left than `most` (approximate convex decomposition
// from below, as Mamou and Ghorbel 2009 join clusters). Done along the axes and along the principal
// ones, of which the smaller sum is taken; each piece becomes the smallest solid about its points.
// What is flat is a millimetre thick. Throws Cancelled. Preconditions: triangles with finite
// corners, not all in one point; most >= 1.
std::vector<Shape> solidPieces(const geometry::TriangleMesh& mesh, int most,
                               const base::RunContext& ctx);

} // namespace voluta::robot
