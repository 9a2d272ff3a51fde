// The solid that a sliced file's beads make, sparse infill included as if it were solid.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"

namespace voluta::base {
class RunContext;
}

namespace voluta::sliced {

struct LayerSolid {
  geometry::TriangleMesh mesh; // Closed, facing outward [mm]
  plan::FillIntent fill;       // Of that solid by the beads
};

// Returns the solid of level layers: the beads and everything within walls that contains infill;
// sparse infill where solid material is above and below it.
// It consists of cells as high as the layers. `sparseShare` > 0:
// for paths whose kinds are guesses. Changes Infill to SparseInfill where, within its walls, beads
// fill less than that of a layer, and fills what other closed paths enclose inside the part.
// Supports and skirts are left out. Preconditions (Error{Internal}): arrays of one length. Throws
// Error{UnusableInput} if a bead has no section or there are no beads of the part; Cancelled.
LayerSolid solidOfLayers(plan::ToolPlan& plan, double sparseShare, const base::RunContext& ctx);

// Returns the volume of the part's beads [mm3], without supports and skirts.
double partBeadsMm3(const plan::ToolPlan& plan);

// Returns whether all nozzles are upright, so that layers are level.
bool isLevel(const plan::ToolPlan& plan);

} // namespace voluta::sliced
