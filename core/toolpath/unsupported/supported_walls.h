// Widths of outermost walls that rest on the layers below.
#pragma once

#include "layers/layer_stack.h"
#include "process/tooling.h"

#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Returns the width of a bead along a rim, from the usual to the process's maximum: the smallest
// width of which enough is supported, otherwise the one with the largest supported share; the usual
// one if nothing supports it. isCarried[i]: supported at sampleMm * (i + 1/2) inside the rim. It
// may extend beyond the widest bead, whose edge rests on material a little further in.
double carriedWidth(const std::vector<char>& isCarried, double sampleMm,
                    const process::Process& process);

// Returns per patch and vertex the width of the outermost wall [mm] at which half of it rests on
// patches of earlier layers. The usual width at inner vertices, on seams, on supports and where no
// earlier patch is near: on the first layer, and where a patch begins in the air. Widths are those
// of the patch's tool. Precondition: print order. Throws Cancelled.
std::vector<std::vector<double>> carriedWallWidths(const layers::LayerStack& stack,
                                                   const process::Tooling& tooling,
                                                   const base::RunContext& ctx);

} // namespace voluta::toolpath
