#include "pipeline/item_loads.h"

#include "base/error.h"
#include "elastic/bead_stiffness.h"
#include "elastic/elastic_solve.h"
#include "regions/region_uses.h"

namespace voluta::pipeline {

namespace {
constexpr std::size_t kCells = 12000; // fine enough for directions
// Any: directions of stress do not depend on the modulus.
constexpr double kModulusMPa = 1000.0, kPoisson = 0.33;
} // namespace

std::shared_ptr<const ItemLoad> itemLoad(const geometry::TriangleMesh& part,
                                         std::span<const project::Region> regions,
                                         std::span<const geometry::TriangleMesh> bodies,
                                         const Eigen::Matrix3d& work_R_file,
                                         const base::RunContext& ctx) {
  std::vector<geometry::TriangleMesh> holds;
  std::vector<elastic::BodyForce> forces;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (bodies[i].empty())
      continue; // not painted yet
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
  if (holds.empty())
    throw base::Error(base::ErrorCode::UnusableInput,
                      "there are regions with a force, but none that holds the part"_text, {},
                      "give a region where the part is fixed the use 'hold'"_text);
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
