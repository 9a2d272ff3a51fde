// What growth could not lay, told in words.
#pragma once

#include "curved/decomposition.h"
#include "voxel/solid_voxels.h"

namespace voluta::curved {

// Counts voxels of rank -1 and describes their connected groups, largest first: shadowed where a
// way through the part from the platform exists, unreached where it does not. The twenty largest
// groups get a finding of their own, the rest one together. Fills missedVoxels, shadowedVoxels,
// unreachedVoxels and findings. Expects grid, rank and platform.
void describeMissed(const voxel::SolidVoxels& voxels, Decomposition& decomposition,
                    const base::RunContext& ctx);

} // namespace voluta::curved
