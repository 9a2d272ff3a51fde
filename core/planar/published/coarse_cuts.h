// Cuts along the borders between a part's regions.
#pragma once

#include "base/run_context.h"
#include "planar/planar_decomposition.h"
#include "planar/published/region_planes.h"

#include <cstdint>
#include <vector>

namespace voluta::planar {

// RoboFDM, phase III: each plane in turn is first perturbed (64 random tries, reproducible: up to
// 2.5 % of the part's diagonal along the normal and 5 degrees; the minimum risky area of the two
// sides wins, with a section at most a fifth larger) and then cuts off the connected solid above it
// at its border. Afterwards pieces are merged with the piece they are printed on as long as that
// does not increase the risky area, best pair first; the piece visited first keeps its base. Planes
// that violate the constraints (constrainedCut) are left out. Sections are tagged from `firstTag`
// on, which is incremented. Throws Cancelled.
std::vector<Piece> coarsePieces(Piece whole, const std::vector<RegionPlane>& planes,
                                const PlanarOptions& options, std::int32_t& firstTag,
                                const base::RunContext& ctx);

} // namespace voluta::planar
