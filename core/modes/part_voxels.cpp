#include "modes/part_voxels.h"

#include "base/memory.h"
#include "base/stopwatch.h"
#include "modes/mode_stages.h"
#include "plan/finding_kinds.h"
#include "voxel/voxel_demand.h"
#include "voxel/wall_thickness.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace voluta::modes {

namespace {
constexpr std::size_t kMaxListed = 5;
constexpr double kMinVoxelMm = 0.1; // minimum of the parameter voxelMm

// Chooses between the two kinds: `fits`, with the voxel width that resolves the wall, or `tooThin`,
// with the minimum voxel width, if no allowed width does.
plan::Finding thinFinding(plan::FindingKind fits, plan::FindingKind tooThin, double thicknessMm,
                          std::vector<plan::NamedValue> values, const voxel::ThinPlace& place,
                          std::size_t facets) {
  const double width = std::floor(100.0 * thicknessMm + 1e-6) / 100.0;
  const bool none = width < kMinVoxelMm;
  values.push_back(none ? plan::NamedValue{"least", base::mm(kMinVoxelMm)}
                        : plan::NamedValue{"fits", base::mm(width)});
  return plan::makeFinding(none ? tooThin : fits, std::move(values), place.at, facets);
}
} // namespace

std::shared_ptr<const PartVoxels> partVoxels(const LoadStage& placed, double voxelMm,
                                             const base::RunContext& ctx) {
  auto out = std::make_shared<PartVoxels>();
  if (placed.voxels) {
    voxel::checkVoxelDemand(*placed.voxels, base::availableMemory());
    out->voxels = placed.voxels;
    return out;
  }
  const base::Stopwatch clock;
  voxel::checkVoxelDemand(*placed.part, voxelMm, base::availableMemory());
  out->voxels = std::make_shared<voxel::SolidVoxels>(
      voxel::solidVoxels(*placed.part, voxelMm, ctx.sub(0.0, 0.5)));
  out->findings = thinWallFindings(*placed.part, voxelMm, ctx.sub(0.5, 1.0));
  out->seconds = clock.seconds();
  return out;
}

plan::Findings thinWallFindings(const geometry::TriangleMesh& part, double voxelMm,
                                const base::RunContext& ctx) {
  const std::vector<voxel::ThinPlace> places = voxel::thinPlaces(part, voxelMm, ctx);
  plan::Findings findings;
  for (std::size_t p = 0; p < std::min(kMaxListed, places.size()); ++p)
    findings.push_back(thinFinding(plan::FindingKind::ThinWall, plan::FindingKind::WallTooThin,
                                   places[p].usualMm,
                                   {{"usual", base::mm(places[p].usualMm)},
                                    {"thinnest", base::mm(places[p].minMm)},
                                    {"voxel", base::mm(voxelMm)}},
                                   places[p], places[p].facets));
  if (places.size() <= kMaxListed)
    return findings;
  double thinnest = places[kMaxListed].usualMm;
  std::size_t facets = 0;
  for (std::size_t p = kMaxListed; p < places.size(); ++p) {
    facets += places[p].facets;
    thinnest = std::min(thinnest, places[p].usualMm);
  }
  findings.push_back(thinFinding(plan::FindingKind::ThinWalls, plan::FindingKind::WallsTooThin,
                                 thinnest,
                                 {{"places", places.size() - kMaxListed},
                                  {"voxel", base::mm(voxelMm)},
                                  {"thinnest", base::mm(thinnest)}},
                                 places[kMaxListed], facets));
  return findings;
}

} // namespace voluta::modes
