#include "pipeline/fill_map.h"

#include "collision/growing_part.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "plan/tool_plan.h"
#include "replay/item_finder.h"
#include "voxel/column_parity.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace voluta::pipeline {

namespace {

// Returns the intended share of each cube that contains some of the part, and 1 of the others.
// `cells`: those of the part per cube; `cellMm3`: the volume of one.
std::vector<double> intendedShares(const geometry::TriangleMesh& part,
                                   std::span<const std::size_t> firstTriangle,
                                   const plan::ToolPlan& plan, const voxel::VoxelGrid& cubes,
                                   const std::vector<double>& cells, double cellMm3) {
  std::vector<double> shares(cubes.cellCount(), 1.0);
  if (std::ranges::all_of(plan.fill, &plan::FillIntent::isSolid))
    return shares;
  const geometry::MeshQuery query(part);
  const replay::ItemFinder items(part, query, firstTriangle, 0.0);
  std::map<std::size_t, std::vector<std::size_t>> sparse; // cubes by item
  std::map<std::size_t, double> volumeMm3;
  for (std::size_t c = 0; c < shares.size(); ++c) {
    if (cells[c] <= 0.0)
      continue;
    const Eigen::Vector3i cell = cubes.cell(c);
    const Eigen::Vector3d centre = cubes.centre(cell.x(), cell.y(), cell.z());
    const std::size_t item = items.at(centre);
    if (query.closest(centre).distance > plan.fillOf(item).shellMm) {
      sparse[item].push_back(c);
      volumeMm3[item] += cellMm3 * cells[c];
    }
  }
  for (const auto& [item, inside] : sparse)
    for (const std::size_t c : inside)
      shares[c] = std::max(0.0, 1.0 - plan.fillOf(item).openMm3 / volumeMm3[item]);
  return shares;
}

} // namespace

FillMap fillMap(const geometry::TriangleMesh& part, std::span<const std::size_t> firstTriangle,
                const plan::ToolPlan& plan, const collision::GrowingPart& growing,
                const base::RunContext& ctx) {
  constexpr double kAcross = 40.0;
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  voxel::VoxelGrid grid;
  grid.pitch = growing.grid().pitch;
  const Eigen::Vector3i shift =
      ((box.min() - growing.grid().origin) / grid.pitch).array().floor().cast<int>();
  grid.origin = growing.grid().origin + grid.pitch * shift.cast<double>();
  grid.size = ((box.max() - grid.origin) / grid.pitch).array().ceil().cast<int>().max(1);
  std::vector<std::uint8_t> inside(grid.cellCount(), 0);
  if (const geometry::TriangleMesh caps = voxel::capsOf(part); caps.triangles.empty())
    voxel::fillClosed(part, grid, inside, ctx);
  else
    voxel::fillOpen(part, caps, grid, inside, ctx);

  FillMap map;
  const int times =
      std::max(1, static_cast<int>(std::ceil(box.sizes().maxCoeff() / kAcross / grid.pitch)));
  map.cellMm = times * grid.pitch;
  map.origin = grid.origin;
  map.size = (grid.size.array() + times - 1) / times;
  const voxel::VoxelGrid cubes{map.origin, map.cellMm, map.size};
  std::vector<double> there(cubes.cellCount(), 0.0), filled(there);
  for (std::size_t c = 0; c < inside.size(); ++c) {
    if (inside[c] == 0)
      continue;
    const Eigen::Vector3i cell = grid.cell(c);
    const std::size_t cube = cubes.index(cell.x() / times, cell.y() / times, cell.z() / times);
    there[cube] += 1.0;
    const Eigen::Vector3i bead = cell + shift;
    if (growing.grid().contains(bead.x(), bead.y(), bead.z()) &&
        growing.filledAt(growing.grid().index(bead.x(), bead.y(), bead.z())) !=
            collision::GrowingPart::kNeverFilled)
      filled[cube] += 1.0;
  }
  map.intended = intendedShares(part, firstTriangle, plan, cubes, there, std::pow(grid.pitch, 3));
  for (std::size_t c = 0; c < there.size(); ++c)
    map.filled.push_back(there[c] > 0.0 ? filled[c] / there[c] : -1.0);
  return map;
}

} // namespace voluta::pipeline
