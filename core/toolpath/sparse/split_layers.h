// Separates the interior that sparse infill fills from walls and skins.
#pragma once

#include "base/run_context.h"
#include "geometry/polygon_paths.h"
#include "layers/layer_stack.h"
#include "toolpath/cover_rules.h"
#include "toolpath/sparse/stack_layers.h"

#include <optional>
#include <span>
#include <vector>

namespace voluta::toolpath {

// The solid part of each patch: its walls and skins. Where it was cut off from the sparse part, its
// rim is an inner rim (layers::Patch::innerRim), so that its infill extends up to the cut.
struct SplitLayers {
  layers::LayerStack solid;                         // Same patches, in the same order
  std::vector<std::optional<layers::Patch>> sparse; // Per patch; nullopt: all of it is solid
  // Per patch of a plane layer: the sparse part in the frame of its PlanePatch.
  std::vector<ClipperLib::Paths> sparseAreas;
};

// A place is sparse if it is inside the walls and not skin: at least topLayers and bottomLayers
// other layers, at least skinMm thick, are between it and the part's surface along the build
// direction. Skins extend by kSkinExtension beads into the sparse part. Sparse parts narrower than
// kMinSparse beads become solid, and so do supports. Plane layers are split as polygons
// (plane_split.h). `rules`: by Patch::region; patches of a region without sparse infill, and
// without a tool of its own for the interior, stay whole. `layers`: of the same stack. Throws
// Cancelled.
SplitLayers splitLayers(const layers::LayerStack& stack, const StackLayers& layers,
                        std::span<const CoverRules> rules, const base::RunContext& ctx);

} // namespace voluta::toolpath
