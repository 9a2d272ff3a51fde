// From a trimmed level surface to the patches that are laid.
#pragma once

#include "layers/layer_stack.h"
#include "layers/level_surface.h"

#include <vector>

namespace voluta::layers {

struct PatchOptions {
  double heightMinMm = 0.4, heightMaxMm = 1.0; // thickness is clamped to this
  double beadWidthMm = 1.2;
};

// A piece that was left out: too small for a bead.
struct DroppedPiece {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double areaMm2 = 0.0, volumeMm3 = 0.0;
  int level = 0;
};

struct PatchesOfLevel {
  std::vector<Patch> patches;
  double areaMm2 = 0.0;         // of the patches
  double withinLimitsMm2 = 0.0; // of it, where the thickness was within the limits before clamping
  std::vector<DroppedPiece> dropped;
};

// The pieces that hang together by edges, each a patch; a vertex in which a boundary touches
// itself becomes two, so that boundary loops are simple. Pieces with less area than a round bead
// (pi/4 w^2) or narrower than half a bead everywhere are dropped. Thickness is clamped.
PatchesOfLevel makePatches(const LevelSurface& surface, const PatchOptions& options);

} // namespace voluta::layers
