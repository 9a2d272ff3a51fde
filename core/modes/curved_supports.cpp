#include "modes/curved_supports.h"

#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "support/column_layers.h"

#include <algorithm>

namespace voluta::modes {

namespace {
using layers::SupportRule;

// Calls `take` for each cell whose lower part is in the body.
template <typename Take>
void eachCellIn(const geometry::TriangleMesh& body, const voxel::VoxelGrid& grid,
                const Take& take) {
  constexpr double kDepth = 0.25; // [cells] below the middle: at the surface that is carried
  const geometry::MeshQuery query(body);
  const Eigen::AlignedBox3d box = geometry::bounds(body);
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3d place =
            grid.centre(i, j, k) - kDepth * grid.pitch * Eigen::Vector3d::UnitZ();
        if (box.contains(place) && query.inside(place))
          take(grid.index(i, j, k));
      }
}

void takePlaces(const layers::SupportPlaces& places, SupportRule rule, const voxel::VoxelGrid& grid,
                support::SupportOptions& options) {
  if (!places.places.empty() || rule != SupportRule::Auto)
    options.rules.assign(grid.cellCount(), rule);
  for (const layers::SupportPlace& place : places.places)
    eachCellIn(place.body, grid, [&](std::size_t cell) { options.rules[cell] = place.rule; });
  if (!places.printedLater.empty())
    options.closed.assign(grid.cellCount(), 0);
  for (const geometry::TriangleMesh& body : places.printedLater)
    eachCellIn(body, grid, [&](std::size_t cell) { options.closed[cell] = 1; });
}

bool isWanted(const layers::SupportPlaces& places, SupportRule rule) {
  return layers::wantsColumns(rule) ||
         std::ranges::any_of(places.places, [](const layers::SupportPlace& place) {
           return layers::wantsColumns(place.rule);
         });
}
} // namespace

support::Supports supportsOf(const voxel::SolidVoxels& part,
                             const std::vector<Eigen::Vector2d>& platform,
                             const curved::CurvedOptions& growth, const WantedSupports& wanted,
                             const layers::SupportPlaces& places, const base::RunContext& ctx) {
  if (!isWanted(places, wanted.rule)) {
    support::Supports none;
    none.solid = part;
    return none;
  }
  support::SupportOptions options;
  options.growth = growth.growth;
  options.forward = growth.forward;
  options.bridgeMm = wanted.bridgeMm;
  takePlaces(places, wanted.rule, part.grid, options);
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
