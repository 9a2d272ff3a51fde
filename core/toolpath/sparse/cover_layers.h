// Covers all patches of a stack: walls, skins and solid infill, and sparse infill inside.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "toolpath/cover_rules.h"
#include "toolpath/coverage/cover_patch.h"

#include <span>
#include <vector>

namespace voluta::toolpath {

struct LayerCovers {
  // Per patch; beads of sparse infill are the last ones. Areas, volumes and coverage are those of
  // the solid part.
  std::vector<PatchCover> covers;
  std::vector<plan::FillIntent> fill; // as plan::ToolPlan::fill
  double sparseMm3 = 0.0;             // volume of the sparse parts
  double sparseBeadMm3 = 0.0;         // volume of their beads
  double sparseAskedMm3 = 0.0;        // volume of beads that their densities ask for
};

// Runs coverPatch() for every patch; with an infill density below 1 for the solid part of each, and
// sparseBeads() for the rest. Solid infill beads that partly rest on a sparse part become
// PathKind::Bridge. `rules`: by Patch::region, those of the item first. Walls and skins are found
// for the item as a whole: a skin is below or above the part's surface, not at the end of a region.
// Reports progress up to `share`. Precondition: rules for each region of the stack's patches.
// Throws Cancelled, Error{Usage}.
LayerCovers coverLayers(const layers::LayerStack& stack, std::span<const CoverRules> rules,
                        double share, const base::RunContext& ctx);

} // namespace voluta::toolpath
