// What becomes of pieces of layers that are too small for a bead.
#pragma once

#include "layers/layer_stack.h"

#include <vector>

namespace voluta::layers {

struct AbsorbOptions {
  double heightMaxMm = 1.0; // to which patches may be thickened
  double beadWidthMm = 1.2; // about as far round a sliver the patch takes part
  double leastShare = 0.0; // of a sliver's volume that must find room: else nothing is done with it
};

// A piece, or what is left of it, that is not laid.
struct DroppedPiece {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double areaMm2 = 0.0, volumeMm3 = 0.0;
  int level = 0;
};

struct Absorbed {
  std::size_t merged = 0; // slivers of which hardly anything (5 %) is left
  double mergedVolumeMm3 = 0.0;
  std::size_t refused = 0; // less than leastShare of them found room
  std::vector<DroppedPiece> dropped;
};

// Lets the patches right under and over each sliver take its volume: inner vertices that face it
// are thickened towards it, evenly, to heightMaxMm at most (their middle moves by half as much;
// boundary vertices stay where they are, on the part). Volume of patches grows by what is merged.
// In the order of `slivers`; patches in any order, those of support left as they are.
Absorbed absorbSlivers(std::vector<Patch>& patches, const std::vector<Patch>& slivers,
                       const AbsorbOptions& options);

} // namespace voluta::layers
