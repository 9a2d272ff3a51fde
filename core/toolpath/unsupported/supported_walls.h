// How wide outermost walls have to be to lie on what is laid below them.
#pragma once

#include "layers/layer_stack.h"
#include "process/process.h"

#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// The width, from the usual one to the process's widest, of a bead along a rim, of which enough
// lies on what is below: the least that does, else the one that has most of it, the usual one where
// none lies on anything. isCarried[i]: something is below it sampleMm * (i + 1/2) inside of the
// rim; may go on beyond the widest bead, whose edge touches what is a little further in.
double carriedWidth(const std::vector<char>& isCarried, double sampleMm,
                    const process::Process& process);

// Per patch, per vertex, mm: the width that an outermost wall should have there, so that half of it
// lies on patches of earlier layers. The usual one at vertices inside, on seams and of supports,
// and where nothing earlier is near: on the first layer, and where a patch begins in the air.
// Precondition: print order. Throws Cancelled.
std::vector<std::vector<double>> carriedWallWidths(const layers::LayerStack& stack,
                                                   const process::Process& process,
                                                   const base::RunContext& ctx);

} // namespace voluta::toolpath
