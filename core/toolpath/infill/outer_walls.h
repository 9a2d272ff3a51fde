// Outermost walls that are wider than other beads.
#pragma once

#include "process/process.h"
#include "toolpath/patch_surface.h"
#include "toolpath/surface_fields.h"

#include <vector>

namespace voluta::toolpath {

// Per vertex, the hatch of the outermost wall that is nearest to it, at least hatchMm: that of the
// width wanted at the rim where the patch has room for it and a bead beside it, changing slowly
// along the rim. `widthMm`: per vertex of the patch that was refined, which are the first of the
// surface (supported_walls.h); empty: the usual one. boundary: per vertex, of boundarySegments();
// hatchMm: per vertex, the usual hatch.
std::vector<double> outerHatches(const PatchSurface& surface, const std::vector<double>& widthMm,
                                 const SegmentDistances& boundary,
                                 const std::vector<double>& hatchMm,
                                 const process::Process& process);

} // namespace voluta::toolpath
