// The solid formed by beads, for tool-paths that come without their part.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"

namespace voluta::base {
class RunContext;
}

namespace voluta::build3mf {

// Returns the surface of the cells, `pitchMm` wide, whose centres are in the volume of the beads:
// process::hatchOf wide, so that neighbouring beads leave no gap and the solid's volume is that of
// the material. Without supports and skirts. Closed [mm]. Preconditions (Error{Internal}): pitch >
// 0, arrays of one length. Throws Error{UnusableInput} if a bead has no section, there are no beads
// or too many cells; Cancelled.
geometry::TriangleMesh solidOfBeads(const plan::ToolPlan& plan, double pitchMm,
                                    const base::RunContext& ctx);

} // namespace voluta::build3mf
