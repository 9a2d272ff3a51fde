// Walls: beads along the boundary of a region.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Returns the centrelines at `level` hatches from the boundary, where the region extends at least
// 0.4 hatch further inwards. Elsewhere two such curves from opposite sides would nearly meet, and
// one bead on the medial line is better (gap_fill.h). This is the morphological opening of the
// offset region: corners are rounded by 0.4 hatch, and narrow parts vanish without open ends.
// depth: per vertex, distance from the boundary in hatches; hatchMm per vertex. beadScale as in
// bead_scale.h.
std::vector<SurfaceCurve> wallAt(const PatchSurface& surface, const std::vector<double>& depth,
                                 const std::vector<double>& hatchMm, double beadScale,
                                 double level);

// Removes outermost walls that are mere rings in a junction of thin walls: a bead along one of the
// thin walls passes through it. A pin, which no thin wall joins, keeps its ring. depth: per vertex,
// distance from the boundary in hatches.
void dropJunctionRings(const PatchSurface& surface, const std::vector<double>& depth,
                       double hatchMm, std::vector<SurfaceCurve>& walls);

} // namespace voluta::toolpath
