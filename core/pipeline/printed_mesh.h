// The part as it will be printed, as one solid.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"
#include "process/process.h"

namespace voluta::pipeline {

// Returns the union of the part's beads (build3mf/bead_cells.h) [mm]: closed, without inner walls
// between adjacent beads, its volume that of the material; without supports and waste. Pores of
// less than about two beads are filled and the steps between cells smoothed. The resolution is
// about half a layer, coarser for large parts. Throws Error{UnusableInput} for beads without a
// section; Cancelled.
geometry::TriangleMesh printedSolid(const plan::ToolPlan& plan, const process::Process& process,
                                    const base::RunContext& ctx);

} // namespace voluta::pipeline
