// Takes the bridges out of plane layers and covers them.
#pragma once

#include "layers/layer_stack.h"
#include "process/process.h"
#include "toolpath/coverage/bead.h"
#include "toolpath/options.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// A layer with bridges.
struct BridgedLayer {
  layers::Patch rest;                    // without them; their rim is an inner rim
  int walls = 0;                         // around the rest: fewer than usual on thin holds
  std::vector<Bead> beads;               // of the bridges
  double areaMm2 = 0.0, volumeMm3 = 0.0; // of the bridges
};

// Returns per patch of `stack` its bridges (bridge_regions.h) inside its walls, of which there are
// fewer where they would leave the bridges no hold; nullopt where there are no bridges, and for
// patches that are not level, for supports, without a layer below, and on platforms other than
// plates. `whole`: the layers that carry those of `stack`. `processOf`: of a patch; `wallWidths`:
// per patch as for coverPatch(); both thread-safe. Throws Cancelled.
std::vector<std::optional<BridgedLayer>>
bridgedLayers(const layers::LayerStack& stack, const layers::LayerStack& whole,
              const std::function<process::Process(std::size_t)>& processOf,
              const std::vector<std::vector<double>>& wallWidths, const ToolpathOptions& options,
              const base::RunContext& ctx);

// Returns the wall widths at the vertices of `rest` from those at the vertices of its patch. Where
// the patch has no vertex the width is `usualMm`.
std::vector<double> wallWidthsOf(const layers::Patch& rest, const layers::Patch& patch,
                                 const std::vector<double>& widthMm, double usualMm);

} // namespace voluta::toolpath
