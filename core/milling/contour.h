// The last pass around a part, which frees it from its block.
#pragma once

#include "milling/mill_passes.h"

#include <vector>

namespace voluta::milling {

struct ContourHeights {
  double highMm = 0.0, lowMm = 0.0; // of the web around the part
  double clearMm = 0.0;             // of moves above the block
};

// Returns closed curves at a distance from the part's silhouette, counter-clockwise around it.
std::vector<std::vector<Eigen::Vector2d>> outlinesAround(const HeightMap& part, double distanceMm);

// Returns the moves that mill the web away, in fine passes from its top to its bottom, half a
// cutter beside the silhouette. A strip at the silhouette's lower end along y stays.
std::vector<MillMove> contourMoves(const HeightMap& part, const MillRule& rule,
                                   const ContourHeights& heights);

} // namespace voluta::milling
