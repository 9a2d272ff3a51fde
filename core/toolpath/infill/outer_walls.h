// Outermost walls that are wider than other beads.
#pragma once

#include "process/process.h"
#include "toolpath/patch_surface.h"
#include "toolpath/surface_fields.h"

#include <vector>

namespace voluta::toolpath {

// Returns per vertex the hatch of the nearest outermost wall, at least hatchMm. It corresponds to
// the width required at the rim where the patch has room for it and for a bead next to it, and
// changes slowly along the rim. `widthMm`: per vertex of the unrefined patch, whose vertices are
// the first of the surface (supported_walls.h); empty: the usual width. boundary: per vertex, from
// boundarySegments(); hatchMm: per vertex, the usual hatch.
std::vector<double> outerHatches(const PatchSurface& surface, const std::vector<double>& widthMm,
                                 const SegmentDistances& boundary,
                                 const std::vector<double>& hatchMm,
                                 const process::Process& process);

} // namespace voluta::toolpath
