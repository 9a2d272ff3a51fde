#include "pipeline/fill_map.h"

#include "collision/growing_part.h"
#include "geometry/measures.h"
#include "voxel/column_parity.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace voluta::pipeline {

FillMap fillMap(const geometry::TriangleMesh& part, const collision::GrowingPart& growing,
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
  for (std::size_t c = 0; c < there.size(); ++c)
    map.filled.push_back(there[c] > 0.0 ? filled[c] / there[c] : -1.0);
  return map;
}

} // namespace voluta::pipeline
