// Layer heights of a piece.
#pragma once

#include "planar/pieces.h"

#include <vector>

namespace voluta::planar {

struct HeightOptions {
  double wantedMm = 0.8, minMm = 0.4, maxMm = 1.0; // 0 < min <= wanted <= max
  bool adaptive = false;
  double cuspMm = 0.2;  // adaptive: maximum deviation of steps from the surface
  double firstMm = 0.0; // height of the first layer; 0: as the others
};

// Returns the heights above the piece's base of the boundaries between its layers, rising from 0 to
// its top. Uniform: layers have the wanted height, adjusted below each relevant flat face
// perpendicular to the base's normal (shelf, ceiling, top; at least 2 % of the piece's
// volume^(2/3)) to make a whole number of layers. Above the last such face the last layer takes the
// remainder, shared with the layer before if it would be lower than minMm. Faces nearer than minMm
// to a larger one are ignored. Adaptive: as high as the surface allows, h |n . d| <= cusp for the
// normal n of every facet beside the layer and the build direction d (Dolenc, Makela 1994); nearly
// flat facets require a boundary at their height instead. All heights are within the limits, except
// that a piece lower than minMm is a single layer. A first layer of its own height comes first if
// at least minMm is left above it; flat faces nearer than minMm to its top are ignored.
std::vector<double> layerBounds(const Piece& piece, const HeightOptions& options);

} // namespace voluta::planar
