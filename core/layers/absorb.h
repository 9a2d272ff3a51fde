// Absorption of pieces of layers that are too small for a bead by neighbouring patches.
#pragma once

#include "layers/layer_stack.h"

#include <vector>

namespace voluta::layers {

struct AbsorbOptions {
  double heightMaxMm = 1.0; // maximum thickness of a thickened patch
  double beadWidthMm = 1.2; // the patch takes part up to about this far around a sliver
  // share of a sliver's volume for which there must be room; otherwise it is left unchanged
  double minShare = 0.0;
};

// A piece, or the rest of it, that is not printed.
struct DroppedPiece {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double areaMm2 = 0.0, volumeMm3 = 0.0;
  int level = 0;
};

struct Absorbed {
  std::size_t merged = 0; // slivers of which at most 5 % are left
  double mergedVolumeMm3 = 0.0;
  std::size_t refused = 0; // slivers with room for less than minShare
  std::vector<DroppedPiece> dropped;
};

// Distributes each sliver's volume to the patches directly below and above it: inner vertices that
// face it are thickened evenly towards it, up to heightMaxMm (their mid-surface moves by half as
// much; boundary vertices stay on the part's surface). The patches' volume grows by the merged
// volume. Slivers are processed in the given order; patches may be in any order. Support patches do
// not change.
Absorbed absorbSlivers(std::vector<Patch>& patches, const std::vector<Patch>& slivers,
                       const AbsorbOptions& options);

} // namespace voluta::layers
