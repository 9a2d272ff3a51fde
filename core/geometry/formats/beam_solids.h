// The beams and balls of a 3MF lattice as closed solids.
#pragma once

#include "geometry/formats/facet_soup.h"
#include "geometry/formats/threemf_model.h"

#include <vector>

namespace voluta::geometry {

// Returns the facets of a closed frustum per beam and of a closed ball per round end and per ball
// of the lattice, in the object's coordinates, facing outward. The solids overlap at the nodes;
// their union is the lattice. Cross-sections and balls have the area and the volume of the round
// ones.
std::vector<Facet> beamSolids(const ThreemfObject& object);

} // namespace voluta::geometry
