// Splitting of a trimmed level surface into printable patches.
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

// Makes a patch of each edge-connected piece; a vertex at which a boundary touches itself is
// duplicated, so that boundary loops are simple. Pieces with less area than a round bead (pi/4 w^2)
// or everywhere narrower than half a bead are slivers (see absorbSlivers). Patch::layer is the
// surface's level.
PatchesOfLevel makePatches(const LevelSurface& surface, const PatchOptions& options);

} // namespace voluta::layers
