// The part as cells: the input of every growth scheme (dissertation 3.4.1).
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
  std::vector<std::uint8_t> solid; // Per cell, 1 where the part is
  std::size_t count = 0;           // Number of solid cells

  // Returns the index k of the layer of cells on the plate; may be outside the grid.
  int plateLayer() const;
};

// How far a facet may extend into a cell without making it solid, as a share of the cell's width,
// so that a face on the boundary of two cells belongs to only one of them.
inline constexpr double kGrazeShare = 1e-3;

// Returns all cells that the part's interior touches: their centre is inside, or a facet extends
// further into them than kGrazeShare. The union of the cells contains the part except for that
// tolerance. Cavities stay empty; overlapping shells are united; inside-out shells count like
// others. Closed meshes are filled by the winding of exact column crossings, others by generalised
// winding numbers (Barill et al. 2018). `mesh` is on the plate [mm]; pitch > 0 [mm]. Throws
// Error{UnusableInput} for an empty mesh and Error{Usage}, naming the smallest possible pitch, if
// the grid would have more cells than maxCells; Cancelled.
// Example:
//   const voxel::SolidVoxels voxels = voxel::solidVoxels(part, 0.8, ctx);
SolidVoxels solidVoxels(const geometry::TriangleMesh& mesh, double pitch,
                        const base::RunContext& ctx, std::size_t maxCells = 400'000'000);

} // namespace voluta::voxel
