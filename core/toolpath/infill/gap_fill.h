// Beads for the gaps that walls and infill leave open.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Maximum distance [mm] from curves at which gaps are searched; for beads of 1.2 mm.
inline constexpr double kGapReachMm = 2.5;

// Returns centrelines along the middle of the area that is inside the patch and outside the
// footprints of existing beads, where it is wider than about half a hatch. Narrower gaps are closed
// by widening the neighbours. outsideMm: per vertex, distance to the nearest footprint (half a
// hatch to either side of its curve), negative inside, exact up to kGapReachMm from the curve.
// boundaryMm: per vertex, distance to the patch's boundary. hatchMm: per vertex. beadScale as in
// bead_scale.h. `narrowest`: hatch of the narrowest bead [hatches]: no gap between beads gets one
// whose neighbours would have to be narrower than that to make room.
std::vector<SurfaceCurve> gapSpines(const PatchSurface& surface,
                                    const std::vector<double>& outsideMm,
                                    const std::vector<double>& boundaryMm,
                                    const std::vector<double>& hatchMm, double beadScale,
                                    double narrowest);

} // namespace voluta::toolpath
