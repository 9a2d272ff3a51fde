// Adaptation of the last layers to the part's top surface.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "layers/part_boundary.h"

namespace voluta::layers {

struct TopOptions {
  double heightMinMm = 0.4, heightMaxMm = 1.0;
  double fineMm = 0.4; // edges are split down to this length where the height changes along them
};

// Where the part's surface is nearly parallel to the layers (within 25 degrees, fading out to 40),
// sets the thickness of the last patch below it such that the patch's top is on the surface, within
// the height limits: between the rims of levels, which are half a layer high, heights vary from
// half a layer to one and a half. Feet do not move; boundary vertices on the part keep their
// position with the minimum height. Triangles are split where necessary, boundary edges never.
// Support patches do not change. Precondition: print order. Throws Cancelled.
void followTop(LayerStack& stack, const PartBoundary& part, const TopOptions& options,
               const base::RunContext& ctx);

} // namespace voluta::layers
