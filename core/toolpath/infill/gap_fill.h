// Beads for what walls and infill leave open.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// How far round curves gaps are looked for, mm, of beads of the usual width.
inline constexpr double kGapReachMm = 2.5;

// Centrelines along the middle of what lies outside the footprints of beads that are there and
// inside the patch, where that is wider than about half a hatch; narrower gaps are closed by
// widening the neighbours.
// outsideMm: per vertex, distance to the nearest footprint (half a hatch to either side of its
// curve), negative inside, right up to kGapReachMm from the curve. boundaryMm: per vertex, distance
// to the patch's boundary. hatchMm: per vertex. beadScale as in bead_scale.h.
std::vector<SurfaceCurve> gapSpines(const PatchSurface& surface,
                                    const std::vector<double>& outsideMm,
                                    const std::vector<double>& boundaryMm,
                                    const std::vector<double>& hatchMm, double beadScale);

} // namespace voluta::toolpath
