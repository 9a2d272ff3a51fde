// How much of a patch its beads cover: footprints painted on samples of the surface. Shares no code
// with the planning but the nearest-segment search.
#pragma once

#include "toolpath/coverage/cover_patch.h"
#include "toolpath/coverage/plane_samples.h"
#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

struct Coverage {
  double areaMm2 = 0.0;    // of all samples
  double coveredMm2 = 0.0; // within half a bead's width of its centreline
  double overlapMm2 = 0.0; // within half a hatch of two beads, or of two stretches of one
};
Coverage measureCoverage(const PatchSurface& surface, const std::vector<Bead>& beads);
// The same of a plane surface.
Coverage measureCoverage(const PlaneSamples& samples, const std::vector<Bead>& beads);

} // namespace voluta::toolpath
