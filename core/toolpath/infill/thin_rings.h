// Beads around a ring-shaped patch that is one to a few beads wide.
#pragma once

#include "process/process.h"
#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Returns closed centrelines from the outer boundary to the inner one, whatever the shape of the
// ring: isolines of the share of the way from one to the other, (k + 1/2)/n. Their number n is that
// whose beads are nearest to the usual width and within the process's limits all around, at most
// `mostBeads`; a ring of less than the narrowest bead has one. Empty for patches without exactly
// two boundaries, with seams, and for rings that need another number of beads from place to place.
std::vector<SurfaceCurve> thinRings(const PatchSurface& surface, const process::Process& process,
                                    int mostBeads);

} // namespace voluta::toolpath
