// Findings about the voxels that growth could not print.
#pragma once

#include "curved/decomposition.h"
#include "voxel/solid_voxels.h"

namespace voluta::curved {

// Determines why each voxel of rank -1 was missed: unreached if there is no path through the part
// from the platform, shadowed if something printed would have carried it, else cascade. Describes
// their connected groups, largest first: the twenty largest get a finding each (for shadowed ones
// with the step from which the front covers them, and the facet), the rest one finding together.
// Fills loss, the counts and findings. Precondition: grid, rank and platform are set. Throws
// Cancelled.
void describeMissed(const voxel::SolidVoxels& voxels, Decomposition& decomposition,
                    const base::RunContext& ctx);

} // namespace voluta::curved
