// Supports in curved mode: growth, report and layers.
#pragma once

#include "base/run_context.h"
#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "modes/mode_stages.h"
#include "support/supports.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::modes {

struct WantedSupports {
  layers::SupportRule rule = layers::SupportRule::Auto; // outside of regions
  double bridgeMm = 0.0;                                // as SupportOptions::bridgeMm
};
// Returns the part's voxels together with the supports they need. If none are wanted or growth
// misses nothing, `solid` is the part and there are no columns. `places`: of regions. Throws as
// support::supportsFor().
support::Supports supportsOf(const voxel::SolidVoxels& part,
                             const std::vector<Eigen::Vector2d>& platform,
                             const curved::CurvedOptions& growth, const WantedSupports& wanted,
                             const layers::SupportPlaces& places, const base::RunContext& ctx);

// Marks the support's voxels in a decomposition of part and support.
void markSupports(const support::Supports& supports, curved::Decomposition& decomposition);

// Adds the supports' results to the stage: missed voxels before and after, volume, findings,
// seconds.
void reportSupports(const support::Supports& supports, DecomposeStage& stage);

// Returns slices of the support with the process's layer heights; empty if there is no support.
std::vector<curved::SupportPatch> supportPatches(const curved::Decomposition& decomposition,
                                                 const geometry::TriangleMesh& part,
                                                 const curved::LayerOptions& cut,
                                                 const base::RunContext& ctx);

} // namespace voluta::modes
