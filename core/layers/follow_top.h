// Last layers that end on the part's surface.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "layers/part_boundary.h"

namespace voluta::layers {

struct TopOptions {
  double heightMinMm = 0.4, heightMaxMm = 1.0;
  double fineMm = 0.4; // edges are split down to this where the height changes along them
};

// Where the part's surface runs nearly along the layers (within 25 degrees, fading out to 40), the
// last patch under it is made as thick there as it takes for its top to lie on the surface, within
// the height limits: between the rims of levels, which are half a layer high, heights run from half
// a layer to one and a half. Feet stay where they are; boundary vertices on the part stay there
// with the height that is least. Triangles are split where that asks for it, boundary edges never.
// Support is left alone. Precondition: print order. Throws Cancelled.
void followTop(LayerStack& stack, const PartBoundary& part, const TopOptions& options,
               const base::RunContext& ctx);

} // namespace voluta::layers
