// Joins the centrelines of gaps that surround a hole.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Joins open curves to a closed one where each ends in front of the next and the last in front of
// the first, so that a ring is one bead. Two ends are joined if they are at most `reachMm` apart
// and point at each other, and the middle between them is in the gap (room > minRoom). Other
// curves are returned as they are; a ring takes the place of its first curve.
std::vector<SurfaceCurve> joinRings(const PatchSurface& surface, std::vector<SurfaceCurve> curves,
                                    const std::vector<double>& room, double minRoom,
                                    double reachMm);

} // namespace voluta::toolpath
