#include "pipeline/item_loads.h"

#include "base/error.h"
#include "elastic/bead_stiffness.h"
#include "elastic/elastic_solve.h"
#include "regions/region_kinds.h"
#include "regions/region_uses.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {
constexpr std::size_t kCells = 12000; // fine enough for directions
// Any: directions of stress do not depend on the modulus.
constexpr double kModulusMPa = 1000.0, kPoisson = 0.33;

bool anyIs(std::span<const project::Region> regions, regions::RegionLoad load) {
  return std::ranges::any_of(regions, [&](const project::Region& region) {
    const bool isPainted =
        regions::parsedShape(region.shape).kind->mesh == regions::ShapeMesh::Painted;
    return regions::findUse(region.use).load == load &&
           !(isPainted && (!region.mesh || region.mesh->empty())); // not painted yet
  });
}
} // namespace

bool isPushed(std::span<const project::Region> regions) {
  return anyIs(regions, regions::RegionLoad::Force);
}

void requireHeld(std::span<const project::Region> regions) {
  if (isPushed(regions) && !anyIs(regions, regions::RegionLoad::Held))
    throw base::Error(base::ErrorCode::Usage,
                      "there are regions with a force, but none that holds the part"_text, {},
                      "give a region where the part is fixed the use 'hold'"_text);
}

std::shared_ptr<const ItemLoad> itemLoad(const geometry::TriangleMesh& part,
                                         std::span<const project::Region> regions,
                                         std::span<const geometry::TriangleMesh> bodies,
                                         const Eigen::Matrix3d& work_R_file,
                                         const base::RunContext& ctx) {
  std::vector<geometry::TriangleMesh> holds;
  std::vector<elastic::BodyForce> forces;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (bodies[i].empty()) // not painted yet
      continue;
    switch (regions::findUse(regions[i].use).load) {
    case regions::RegionLoad::Held:
      holds.push_back(bodies[i]);
      break;
    case regions::RegionLoad::Force:
      forces.push_back({bodies[i], work_R_file * regions::forceOf(regions[i].use)});
      break;
    case regions::RegionLoad::None:
      break;
    }
  }
  if (forces.empty())
    return nullptr;
  requireHeld(regions);
  elastic::LoadCase cells = elastic::loadCase(part, holds, forces, kCells, ctx);
  const elastic::Stiffness6 material = elastic::isotropicStiffness(kModulusMPa, kPoisson);
  const elastic::ElasticState state = elastic::solved(
      cells, [&](std::size_t) { return material; }, ctx);
  elastic::PrincipalStress principal(cells, state);
  elastic::TensionAcross tension(cells, state);
  return std::make_shared<const ItemLoad>(
      ItemLoad{std::move(cells), std::move(principal), std::move(tension)});
}

} // namespace voluta::pipeline
