// Beads for what walls and infill leave open.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Centrelines along the middle of what lies outside the footprints of `curves` (half a hatch to
// either side) and inside the patch, where that is wider than about half a hatch; narrower gaps are
// closed by widening the neighbours.
// boundaryMm: per vertex, distance to the patch's boundary. hatchMm: per vertex. beadScale as in
// bead_scale.h.
std::vector<SurfaceCurve> gapSpines(const PatchSurface& surface,
                                    const std::vector<SurfaceCurve>& curves,
                                    const std::vector<double>& boundaryMm,
                                    const std::vector<double>& hatchMm, double beadScale);

} // namespace voluta::toolpath
