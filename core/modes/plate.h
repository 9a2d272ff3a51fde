// The plate that a part's voxels are grown from.
#pragma once

#include "project/platform.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::modes {

// Its corners, convex, counter-clockwise, mm. `own`: the plate that the part brought along, which
// one that is made for the part then follows; empty: none, and that is the hull of the cells that
// stand on it. Throws as Platform::plateAround() and curved::platformFit().
std::vector<Eigen::Vector2d> plateOf(const project::Platform& platform,
                                     const voxel::SolidVoxels& voxels,
                                     const std::vector<Eigen::Vector2d>& own = {});

} // namespace voluta::modes
