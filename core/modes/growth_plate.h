// The plate from which a part's voxels are grown.
#pragma once

#include "project/platform.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::modes {

// Returns the plate's corners [mm], convex and counter-clockwise. `own`: polygon of the part's own
// platform. A plate of automatic size follows it, or the convex hull of the cells that touch the
// plate if `own` is empty. Throws as Platform::plateAround() and curved::platformFit().
std::vector<Eigen::Vector2d> plateOf(const project::Platform& platform,
                                     const voxel::SolidVoxels& voxels,
                                     const std::vector<Eigen::Vector2d>& own = {});

} // namespace voluta::modes
