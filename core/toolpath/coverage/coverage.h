// Measures how much of a patch its beads cover, by painting their footprints on samples of the
// surface. Shares no code with the planning except the nearest-segment search.
#pragma once

#include "toolpath/coverage/cover_patch.h"
#include "toolpath/coverage/plane_samples.h"
#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

struct Coverage {
  double areaMm2 = 0.0;    // Area of all samples
  double coveredMm2 = 0.0; // Within half a bead width of a centreline
  double overlapMm2 = 0.0; // Within half a hatch of two beads, or of two parts of one bead
};
Coverage measureCoverage(const PatchSurface& surface, const std::vector<Bead>& beads);
// The same for a plane surface.
Coverage measureCoverage(const PlaneSamples& samples, const std::vector<Bead>& beads);

} // namespace voluta::toolpath
