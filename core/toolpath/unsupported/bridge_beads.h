// Beads of bridges.
#pragma once

#include "process/process.h"
#include "toolpath/coverage/bead.h"
#include "toolpath/plane/plane_patch.h"
#include "toolpath/unsupported/bridge_regions.h"

#include <vector>

namespace voluta::toolpath {

// Returns straight lines over the region in its direction. They are evenly spaced, a hatch apart as
// nearly as they fill its width, and as wide as they fill it. Neighbours are joined where their
// joint rests on `below`; no bead turns in the air. Beads whose spans all have holds at both ends
// and are no longer than `longestMm` are of kind Bridge, others Infill. `plane`: the layer.
std::vector<Bead> bridgeBeads(const BridgeRegion& region, const ClipperLib::Paths& below,
                              const PlanePatch& plane, const process::Process& process,
                              double longestMm, double stepMm);

} // namespace voluta::toolpath
