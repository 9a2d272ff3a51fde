// The voxels of a placed part, and findings about walls thinner than a voxel.
#pragma once

#include "plan/finding.h"
#include "project/job_stage.h"

#include <memory>

namespace voluta::base {
class RunContext;
}
namespace voluta::geometry {
struct TriangleMesh;
}
namespace voluta::voxel {
struct SolidVoxels;
}

namespace voluta::modes {

struct LoadStage;

// Voxelizes the placed mesh with cells of voxelMm > 0; for a voxel object, returns its own cells.
// The findings report walls of the mesh that are thinner than a voxel. Throws as
// voxel::checkVoxelDemand() if memory does not suffice, as voxel::solidVoxels(), and Cancelled.
struct PartVoxels {
  static constexpr project::Stage kStage = project::Stage::Decompose; // part of the Decompose stage
  std::shared_ptr<const voxel::SolidVoxels> voxels;
  plan::Findings findings;
  double seconds = 0.0; // computing time
};
std::shared_ptr<const PartVoxels> partVoxels(const LoadStage& placed, double voxelMm,
                                             const base::RunContext& ctx);

// Returns findings for walls thinner than a voxel of `voxelMm`: at most five for the largest places
// and one for all others. None of them blocks. The value "fits" is the voxel width that resolves
// the wall; it is absent if the parameter does not allow a voxel that narrow. Precondition: voxelMm
// > 0. Throws Cancelled.
plan::Findings thinWallFindings(const geometry::TriangleMesh& part, double voxelMm,
                                const base::RunContext& ctx);

} // namespace voluta::modes
