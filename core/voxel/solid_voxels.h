// The part as cells: what every growth scheme starts from (dissertation 3.4.1).
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "voxel/voxel_grid.h"

#include <cstdint>
#include <vector>

namespace voluta::voxel {

// The plate z = 0 is a boundary between two layers of cells. The outermost cells on every side are
// empty, so a solid cell always has neighbours inside the grid.
struct SolidVoxels {
  VoxelGrid grid;
  std::vector<std::uint8_t> solid; // per cell, 1 where the part is
  std::size_t count = 0;           // of solid cells

  // Index k of the layer of cells that stands on the plate; may lie outside the grid.
  int plateLayer() const;
};

// How deep a facet may reach into a cell without making it solid, as a share of the cell's width:
// a face that lies on the boundary of two cells belongs to one of them.
inline constexpr double kGrazeShare = 1e-3;

// All cells that the part touches with its interior: their centre is inside, or a facet reaches
// deeper into them than kGrazeShare. The union of the cells contains the part but for that graze.
// Cavities stay empty; overlapping shells add up; shells that are inside out count like others.
// Closed meshes are filled by the winding of exact column crossings, others by generalised winding
// numbers (Barill et al. 2018).
// `mesh` stands on the plate, mm; pitch > 0, mm.
// Throws Error{UnusableInput} for an empty mesh and Error{Usage} when the grid would have more
// cells than maxCells (it names the least pitch that fits); Cancelled.
// Example:
//   const voxel::SolidVoxels voxels = voxel::solidVoxels(part, 0.8, ctx);
SolidVoxels solidVoxels(const geometry::TriangleMesh& mesh, double pitch,
                        const base::RunContext& ctx, std::size_t maxCells = 400'000'000);

} // namespace voluta::voxel
