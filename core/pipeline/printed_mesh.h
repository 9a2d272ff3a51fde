// The part as it will be printed, as one solid.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"
#include "process/process.h"

namespace voluta::pipeline {

// The solid that the part's beads make together (build3mf/bead_cells.h): closed, without walls
// inside where beads lie side by side, its volume the material's; supports and waste left out.
// Pores of less than about two beads are filled. Steps of its cells are smoothed. About half a
// layer fine, coarser for large parts. mm. Throws Error{UnusableInput}: beads without a section;
// Cancelled.
geometry::TriangleMesh printedSolid(const plan::ToolPlan& plan, const process::Process& process,
                                    const base::RunContext& ctx);

} // namespace voluta::pipeline
