// The solid that beads make together, for tool-paths that come without the part they are of.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"

namespace voluta::base {
class RunContext;
}

namespace voluta::build3mf {

// The surface of the cells, `pitchMm` wide, whose centres lie in the room that beads are laid for:
// process::hatchOf wide, so that beads side by side leave nothing between them and the solid's
// volume is the material's. Without supports and skirts. Closed; mm.
// Preconditions (Error{Internal}): pitch > 0, arrays of one length.
// Throws Error{UnusableInput}: a bead has no section, no beads, more cells than can be held;
// Cancelled.
geometry::TriangleMesh solidOfBeads(const plan::ToolPlan& plan, double pitchMm,
                                    const base::RunContext& ctx);

} // namespace voluta::build3mf
