// The surface of a solid of layers: that of its cells, moved onto the outlines of the beads.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"
#include "sliced/layer_mask.h"
#include "sliced/layer_slabs.h"
#include "voxel/voxel_object.h"

namespace voluta::base {
class RunContext;
}

namespace voluta::sliced {

// Returns the surface of the object's cells [mm], closed, facing outward. `object`: one layer of
// cells per slab. Cells alone would state the sides of a wall to within half a cell, which is a
// large share of a wall of one bead. Each corner moves to the mean of the places where the edges
// between the centres of its cells cross the outline of the beads ("surface nets", Gibson 1998),
// and up or down to the top or bottom of the beads, by less than half a cell. Corners beside solid
// cells that no bead covers stay. Preconditions (Error{Internal}): the object has the size of field
// and slabs. Throws Cancelled.
geometry::TriangleMesh surfaceOfLayers(const voxel::VoxelObject& object, const plan::ToolPlan& plan,
                                       const LayerSlabs& slabs, const LayerMask::Field& field,
                                       const base::RunContext& ctx);

} // namespace voluta::sliced
