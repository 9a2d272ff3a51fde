// From a trimmed level surface to the patches that are laid.
#pragma once

#include "layers/layer_stack.h"
#include "layers/level_surface.h"

#include <cstdint>
#include <vector>

namespace voluta::layers {

struct PatchOptions {
  double beadWidthMm = 1.2;
};

struct PatchesOfLevel {
  std::vector<Patch> patches;
  std::vector<Patch> slivers; // too small for a bead
};

// The pieces that hang together by edges, each a patch; a vertex in which a boundary touches
// itself becomes two, so that boundary loops are simple. Pieces with less area than a round bead
// (pi/4 w^2) or narrower than half a bead everywhere are slivers (see absorbSlivers). Patch::layer
// is the surface's level.
PatchesOfLevel makePatches(const LevelSurface& surface, const PatchOptions& options);

} // namespace voluta::layers
