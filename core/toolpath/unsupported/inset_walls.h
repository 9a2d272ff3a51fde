// Insets unsupported walls to where the layer below supports them.
#pragma once

#include "toolpath/unsupported/unsupported_pass.h"

namespace voluta::toolpath {

// Where the rim of a layer overhangs that of the layer below by more than the widest bead
// (supported_walls.h), its wall would be printed beside the part. Stretches that are supported over
// less than a quarter of their width (kMinSupportedSamples) and are longer than half of the
// process's bridge length are therefore offset sideways: by the minimum that supports a quarter of
// the width, at most half a bead, tapered along the path. Where that is not enough they are not
// moved. An offset bead overlaps its neighbour, and the part is short, by the same amount. Walls
// only. Clears the marks of moved waypoints.
std::optional<PassResult> insetUnsupportedWalls(const UnsupportedBeads& beads, const SeenPart& part,
                                                const PassScene& scene,
                                                const base::RunContext& ctx);

} // namespace voluta::toolpath
