// Thickens beads that would be unsupported a little above printed material.
#pragma once

#include "toolpath/unsupported/unsupported_pass.h"

namespace voluta::toolpath {

// In unsupported stretches (bridges.h) longer than half of the bridge length of their tool's
// process, thickens beads down to earlier material if that is within the remaining layer height
// range. Their tips stay; the speed is limited by the extruder's flow for the larger section.
// Clears their marks. Precondition: the part contains the plan's beads.
std::optional<PassResult> thickenUnsupported(const UnsupportedBeads& beads, const SeenPart& part,
                                             const PassScene& scene, const base::RunContext& ctx);

} // namespace voluta::toolpath
