// What one pass of reverse growth loses of a part on a coarse grid: what ways to lie are compared
// by.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <vector>

namespace voluta::placement {

// The platform under a part, as in curved::voxelGraph(). Empty: the hull of what touches the plate.
using PlatformOf = std::function<std::vector<Eigen::Vector2d>(const voxel::SolidVoxels&)>;

struct CoarseGrowth {
  std::size_t voxels = 0, missed = 0;
};

// How a turned part is grown.
struct CoarseGrid {
  double pitchMm = 0.8;               // > 0
  Eigen::Vector2d centreMm{0.0, 0.0}; // where the part's box is centred
  PlatformOf platform = {};
};

// The width, at least `leastMm` > 0, at which the mesh turned by `turn` has about `wanted` voxels.
// Throws as voxel::solidVoxels().
double coarseWidth(const geometry::TriangleMesh& mesh, const Eigen::Quaterniond& turn,
                   double leastMm, std::size_t wanted, const base::RunContext& ctx);

// Of the mesh turned by each of `turns`, put on the plate. Throws as voxel::solidVoxels().
std::vector<CoarseGrowth> coarseGrowths(const geometry::TriangleMesh& mesh,
                                        const std::vector<Eigen::Quaterniond>& turns,
                                        const CoarseGrid& grid, const base::RunContext& ctx);

} // namespace voluta::placement
