// A part cut where its regions meet.
#pragma once

#include "base/run_context.h"
#include "planar/decomposition.h"
#include "planar/published/region_planes.h"

#include <cstdint>
#include <vector>

namespace voluta::planar {

// RoboFDM, phase III: in turn each plane, first perturbed (64 random tries, the same each time: up
// to 2.5 % of the part's diagonal along the normal and 5 degrees; least risky area of the two
// sides, a section at most a fifth larger), cuts off what hangs together above it at its border;
// then pieces are merged with what they stand on as long as that leaves no more risky area, best
// pair first, the piece visited first giving the base. Planes that may not be cut (constrainedCut)
// are left out. Sections are tagged from `firstTag` on, which grows past them. Throws Cancelled.
std::vector<Piece> coarsePieces(Piece whole, const std::vector<RegionPlane>& planes,
                                const PlanarOptions& options, std::int32_t& firstTag,
                                const base::RunContext& ctx);

} // namespace voluta::planar
