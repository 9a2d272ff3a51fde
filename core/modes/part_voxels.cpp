#include "modes/part_voxels.h"

#include "base/memory.h"
#include "base/stopwatch.h"
#include "voxel/voxel_demand.h"
#include "voxel/wall_thickness.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace voluta::modes {

namespace {
constexpr std::size_t kMostListed = 5;
constexpr double kLeastVoxelMm = 0.1; // of the parameter voxelMm

void addRemedy(plan::Finding& finding, double thicknessMm) {
  const double fits = std::floor(100.0 * thicknessMm + 1e-6) / 100.0;
  if (fits < kLeastVoxelMm) {
    finding.remedy = fmt::format("thicken the wall to {:g} mm or more", kLeastVoxelMm);
    finding.remedyMm = std::nullopt;
  } else {
    finding.remedy = fmt::format("a voxel width of at most {:g} mm", fits);
    finding.remedyMm = fits;
  }
}

plan::Finding findingOf(const voxel::ThinPlace& place, double voxelMm) {
  plan::Finding finding;
  finding.stage = "decompose";
  finding.kind = "thinWalls";
  finding.where = place.at;
  finding.count = place.facets;
  finding.reason = fmt::format("a wall {:.2f} mm thick ({:.2f} mm at its thinnest) is thinner than "
                               "a voxel of {:g} mm",
                               place.usualMm, place.leastMm, voxelMm);
  addRemedy(finding, place.usualMm);
  finding.blocking = false;
  return finding;
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
  for (std::size_t p = 0; p < std::min(kMostListed, places.size()); ++p)
    findings.push_back(findingOf(places[p], voxelMm));
  if (places.size() <= kMostListed)
    return findings;
  plan::Finding rest = findingOf(places[kMostListed], voxelMm);
  double thinnest = places[kMostListed].usualMm;
  rest.count = 0;
  for (std::size_t p = kMostListed; p < places.size(); ++p) {
    rest.count += places[p].facets;
    thinnest = std::min(thinnest, places[p].usualMm);
  }
  rest.reason = fmt::format("{} smaller places are thinner than a voxel of {:g} mm; this is the "
                            "largest, the thinnest is {:.2f} mm thick",
                            places.size() - kMostListed, voxelMm, thinnest);
  addRemedy(rest, thinnest);
  findings.push_back(rest);
  return findings;
}

} // namespace voluta::modes
