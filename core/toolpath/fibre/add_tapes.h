// Adds tapes of continuous fibre to a plan (Dai 5.3), each on the finished plastic of its layer.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "plan/statistics.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "toolpath/options.h"

namespace voluta::toolpath {

// Adds the tapes of the chosen layers behind the beads of the layer, for the first tool that lays
// tape; directions are the layer's normals, and there is a waypoint where the tape is cut. Plastic
// is not moved or reduced: a tape is far thinner than a layer. Sets the figures of the cover; those
// of the paths are setPathFigures()'s (path_figures.h). Returns findings. Precondition: plan.paths
// name patches of the stack. Throws Cancelled; Error{Usage} if no tool lays tape or the paths are
// unknown.
plan::Findings addTapes(plan::ToolPlan& plan, const layers::LayerStack& stack,
                        const process::Tooling& tooling, const FibreOptions& options,
                        plan::ToolpathStatistics& statistics, const base::RunContext& ctx);

} // namespace voluta::toolpath
