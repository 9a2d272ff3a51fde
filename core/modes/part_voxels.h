// A part's voxels, and what can be said of them before they are grown.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "modes/stages.h"
#include "plan/finding.h"
#include "voxel/solid_voxels.h"

#include <memory>

namespace voluta::modes {

// A voxel object's own cells, or those of the placed mesh, voxelMm > 0 wide. Findings: walls of the
// mesh that are thinner than that. Throws as voxel::checkVoxelDemand() where memory would not
// do, and as voxel::solidVoxels(); Cancelled.
struct PartVoxels {
  static constexpr project::Stage kStage = project::Stage::Decompose; // a part of it
  std::shared_ptr<const voxel::SolidVoxels> voxels;
  plan::Findings findings;
  double seconds = 0.0; // that it took
};
std::shared_ptr<const PartVoxels> partVoxels(const LoadStage& placed, double voxelMm,
                                             const base::RunContext& ctx);

// Places whose walls are thinner than a voxel of `voxelMm`: five findings at most for the largest,
// and one for the rest. None of them blocks; the value "fits" is the voxel
// width that holds the wall, none where no voxel is that narrow. Precondition: voxelMm > 0. Throws
// Cancelled.
plan::Findings thinWallFindings(const geometry::TriangleMesh& part, double voxelMm,
                                const base::RunContext& ctx);

} // namespace voluta::modes
