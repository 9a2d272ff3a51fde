#include "pipeline/fill_map.h"

#include "collision/growing_part.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "plan/tool_plan.h"
#include "voxel/column_parity.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace voluta::pipeline {

namespace {

// Returns the intended share of each cube that contains some of the part, and 1 of the others.
// `partMm3`: of the part per cube.
std::vector<double> intendedShares(const geometry::TriangleMesh& part,
                                   std::span<const std::size_t> firstTriangle,
                                   const plan::ToolPlan& plan, const voxel::VoxelGrid& cubes,
                                   const std::vector<double>& partMm3) {
  std::vector<double> shares(cubes.cellCount(), 1.0);
  if (std::ranges::all_of(plan.fill, &plan::FillIntent::isSolid))
    return shares;
  const geometry::MeshQuery query(part);
  const auto itemOf = [&](int triangle) {
    const auto after = std::ranges::upper_bound(firstTriangle, static_cast<std::size_t>(triangle));
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - firstTriangle.begin() - 1));
  };
  std::map<std::size_t, std::vector<std::size_t>> sparse; // cubes by item
  std::map<std::size_t, double> volumeMm3;
  for (std::size_t c = 0; c < shares.size(); ++c) {
    if (partMm3[c] <= 0.0)
      continue;
    const Eigen::Vector3i cell = cubes.cell(c);
    const geometry::MeshQuery::Closest nearest =
        query.closest(cubes.centre(cell.x(), cell.y(), cell.z()));
    const std::size_t item = itemOf(nearest.triangle);
    if (nearest.distance > plan.fillOf(item).shellMm) {
      sparse[item].push_back(c);
      volumeMm3[item] += partMm3[c];
    }
  }
  for (const auto& [item, cells] : sparse)
    for (const std::size_t c : cells)
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
  const double cellMm3 = std::pow(grid.pitch, 3);
  std::vector<double> partMm3(there);
  for (double& volume : partMm3)
    volume *= cellMm3;
  map.intended = intendedShares(part, firstTriangle, plan, cubes, partMm3);
  for (std::size_t c = 0; c < there.size(); ++c)
    map.filled.push_back(there[c] > 0.0 ? filled[c] / there[c] : -1.0);
  return map;
}

} // namespace voluta::pipeline
