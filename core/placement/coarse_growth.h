// The voxels that one pass of reverse growth misses on a coarse grid: the criterion for comparing
// orientations.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <vector>

namespace voluta::placement {

// Returns the platform under a part, as in curved::voxelGraph(). Empty: the hull of the voxels on
// the plate.
using PlatformOf = std::function<std::vector<Eigen::Vector2d>(const voxel::SolidVoxels&)>;

struct CoarseGrowth {
  std::size_t voxels = 0, missed = 0;
};

// Grid for growing a rotated part.
struct CoarseGrid {
  double pitchMm = 0.8;               // > 0
  Eigen::Vector2d centreMm{0.0, 0.0}; // centre of the part's bounding box
  PlatformOf platform = {};
};

// Returns the width, at least `minMm` > 0, at which the mesh rotated by `rotation` has about
// `wanted` voxels. Throws as voxel::solidVoxels().
double coarseWidth(const geometry::TriangleMesh& mesh, const Eigen::Quaterniond& rotation,
                   double minMm, std::size_t wanted, const base::RunContext& ctx);

// Returns the result for the mesh rotated by each of `turns` and placed on the plate. Throws as
// voxel::solidVoxels().
std::vector<CoarseGrowth> coarseGrowths(const geometry::TriangleMesh& mesh,
                                        const std::vector<Eigen::Quaterniond>& turns,
                                        const CoarseGrid& grid, const base::RunContext& ctx);

} // namespace voluta::placement
