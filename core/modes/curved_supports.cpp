#include "modes/curved_supports.h"

#include "support/column_layers.h"

namespace voluta::modes {

support::Supports supportsOf(const voxel::SolidVoxels& part,
                             const std::vector<Eigen::Vector2d>& platform,
                             const curved::CurvedOptions& growth, double bridgeMm, bool wanted,
                             const base::RunContext& ctx) {
  if (!wanted) {
    support::Supports none;
    none.solid = part;
    return none;
  }
  support::SupportOptions options;
  options.growth = growth.growth;
  options.forward = growth.forward;
  options.bridgeMm = bridgeMm;
  if (const process::HeadShape* head = curved::headForLosses(growth))
    options.head = *head;
  return support::supportsFor(part, platform, options, ctx);
}

void markSupports(const support::Supports& supports, curved::Decomposition& decomposition) {
  if (supports.support.empty())
    return;
  decomposition.support = supports.support;
  decomposition.supportVoxels = supports.voxels;
  decomposition.voxels = supports.solid.count - supports.voxels;
}

void reportSupports(const support::Supports& supports, DecomposeStage& stage) {
  project::DecompositionReport& r = stage.report;
  const double pitch = r.voxelMm;
  r.missedAfterSupports = r.missedVoxels;
  r.supportVolumeMm3 = static_cast<double>(supports.voxels) * pitch * pitch * pitch;
  if (supports.missedBefore > 0) {
    r.missedVoxels = supports.missedBefore;
    r.unreachedVoxels = supports.unreachedBefore;
    r.shadowedVoxels = supports.missedBefore - supports.unreachedBefore;
  }
  stage.findings.insert(stage.findings.end(), supports.findings.begin(), supports.findings.end());
  stage.timings.grow += supports.seconds;
}

std::vector<curved::SupportPatch> supportPatches(const curved::Decomposition& decomposition,
                                                 const geometry::TriangleMesh& part,
                                                 const curved::LayerOptions& cut,
                                                 const base::RunContext& ctx) {
  support::ColumnLayerOptions options;
  options.layerHeightMm = cut.layerHeightMm;
  options.heightMinMm = cut.heightMinMm;
  options.heightMaxMm = cut.heightMaxMm;
  options.beadWidthMm = cut.beadWidthMm;
  return support::columnLayers(decomposition, part, options, ctx);
}

} // namespace voluta::modes
