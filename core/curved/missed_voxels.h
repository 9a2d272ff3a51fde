// What growth could not lay, told in words.
#pragma once

#include "curved/decomposition.h"
#include "voxel/solid_voxels.h"

namespace voluta::curved {

// Says of each voxel of rank -1 why: unreached where no way through the part leads from the
// platform to it, shadowed where something laid would have carried it, else cascade. Describes
// their connected groups, largest first: the twenty largest get a finding of their own (of shadowed
// ones from which step on the front covers them, and with which facet), the rest one together.
// Fills loss, the counts and findings. Expects grid, rank and platform. Throws Cancelled.
void describeMissed(const voxel::SolidVoxels& voxels, Decomposition& decomposition,
                    const base::RunContext& ctx);

} // namespace voluta::curved
