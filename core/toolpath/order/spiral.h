// Spirals: one continuous bead with rising height instead of a closed bead per layer.
#pragma once

#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/options.h"
#include "toolpath/order/assemble.h"

#include <optional>
#include <vector>

namespace voluta::toolpath {

// Returns the options of the beads that a spiral joins: one wall, solid bottom layers, no supports
// under rims.
ToolpathOptions spiralOptions(ToolpathOptions options);

// Removes all beads but the closed outermost walls from patches that have such walls, from layer
// `bottomLayers` on; supports stay. Where contours of one layer touch, their walls are joined to
// one. `outerAlone`: only the largest wall of each layer stays. Returns the intent of the material
// that is left. Precondition: one cover a patch.
std::vector<plan::FillIntent> keepOuterWalls(const layers::LayerStack& stack, int bottomLayers,
                                             bool outerAlone, std::vector<PatchCover>& covers);

// Joins consecutive layers of one closed bead each to one open path, as long as each layer
// continues the layer before. The path runs level along the first bead, and then once around per
// layer: along the bead of a layer it rises from the bead below to it, in proportion to the length,
// its height that of the gap below; one further level turn, of falling height, ends it. The volume
// is that of the beads. Other layers stay as they are; the first of them from layer `bottomLayers`
// on is reported. Precondition: print order.
std::optional<plan::Finding> joinSpiral(Assembled& assembled, int bottomLayers);

} // namespace voluta::toolpath
