// Supports on the way through curved mode: what is grown, what is told, what is laid.
#pragma once

#include "base/run_context.h"
#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "modes/stages.h"
#include "support/supports.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::modes {

// The part's voxels with support where it is wanted. Where it is not, or where growth
// misses nothing, `solid` is the part and there are no columns. bridgeMm: as SupportOptions. Throws
// as support::supportsFor().
support::Supports supportsOf(const voxel::SolidVoxels& part,
                             const std::vector<Eigen::Vector2d>& platform,
                             const curved::CurvedOptions& growth, double bridgeMm, bool wanted,
                             const base::RunContext& ctx);

// Tells the support's voxels in a decomposition of part and support together apart from the part's.
void markSupports(const support::Supports& supports, curved::Decomposition& decomposition);

// Puts what supports did into the stage: misses before and after, volume, findings, seconds.
void tellSupports(const support::Supports& supports, DecomposeStage& stage);

// Slices of the support as the process lays them. Empty where there is none.
std::vector<curved::SupportPatch> supportPatches(const curved::Decomposition& decomposition,
                                                 const geometry::TriangleMesh& part,
                                                 const curved::LayerOptions& cut,
                                                 const base::RunContext& ctx);

} // namespace voluta::modes
