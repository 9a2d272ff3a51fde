// Tilts unsupported beads so that they are pressed against their neighbours.
#pragma once

#include "toolpath/unsupported/unsupported_pass.h"

namespace voluta::toolpath {

// In stretches that can be pressed against their neighbours (tiltable_stretches.h), tilts the
// directions sideways by the minimum angle that supports a quarter of the bead's width
// (kMinSupportedSamples), at most 50 degrees, tapered along the path. The middle of the bead stays
// in place. Not tilted where that does not help, nor in upright plans. Clears the marks of tilted
// waypoints. Reports the paths whose beads keep a tilt ("braced") once directions are chosen.
std::optional<PassResult> tiltUnsupportedBeads(const UnsupportedBeads& beads, const SeenPart& part,
                                               const PassScene& scene, const base::RunContext& ctx);

} // namespace voluta::toolpath
