// How high the layers of a piece are.
#pragma once

#include "planar/pieces.h"

#include <vector>

namespace voluta::planar {

struct HeightOptions {
  double wantedMm = 0.8, minMm = 0.4, maxMm = 1.0; // 0 < min <= wanted <= max
  bool adaptive = false;
  double cuspMm = 0.2; // adaptive: how far steps may stand out of the surface
};

// Heights over the piece's base of the boundaries between its layers, rising from 0 to its top.
// All layers are as high as wanted; up to each flat face across the base's normal (shelf, ceiling,
// top) that counts, 2 % of the piece's volume^(2/3), by as much less or more as makes a whole
// number of them; over the last one the last layer is what is left, shared with the one before
// where it would be lower than the least height. Faces nearer than that to a larger one are passed
// over. Adaptive: as high as the surface allows, h |n . d|
// <= cusp for the normal n of every facet beside the layer and the build direction d (Dolenc,
// Makela 1994); what is all but flat asks for a boundary at its height instead. Within the limits,
// but for a piece that is lower than the least height: it is one layer.
std::vector<double> layerBounds(const Piece& piece, const HeightOptions& options);

} // namespace voluta::planar
