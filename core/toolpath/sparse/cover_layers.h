// Covers all patches of a stack: walls, skins and solid infill, and sparse infill inside.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/options.h"

#include <vector>

namespace voluta::toolpath {

struct LayerCovers {
  // Per patch; beads of sparse infill are the last ones. Areas, volumes and coverage are those of
  // the solid part.
  std::vector<PatchCover> covers;
  std::vector<plan::FillIntent> fill; // as plan::ToolPlan::fill
  double sparseMm3 = 0.0;     // Volume of the sparse parts
  double sparseBeadMm3 = 0.0; // Volume of their beads
};

// Runs coverPatch() for every patch; with an infill density below 1 for the solid part of each, and
// sparseBeads() for the rest. Solid infill beads that partly rest on a sparse
// part become PathKind::Bridge. Reports progress up to `share`. Throws Cancelled, Error{Usage}.
LayerCovers coverLayers(const layers::LayerStack& stack, const process::Tooling& tooling,
                        const ToolpathOptions& options, double share, const base::RunContext& ctx);

} // namespace voluta::toolpath
