// Determines which cells of a column have their centre inside a mesh.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "voxel/voxel_grid.h"

#include <cstdint>
#include <vector>

namespace voluta::voxel {

// Returns facets that close a mesh: together with them, every directed edge has as many opposite
// ones, with vertices compared by position, so that each line crosses the two together with total
// winding zero. Empty if the mesh is already closed. Each connected group of open edges gets a fan
// about its centre.
geometry::TriangleMesh capsOf(const geometry::TriangleMesh& mesh);

// Sets solid[cell] = 1 where the winding number of the mesh about the cell's centre is not zero.
// Crossings of the vertical line through each column are decided edge by edge with the same
// arithmetic for both triangles at an edge, so a line through an edge or a vertex of a closed mesh
// is never counted twice or lost. Preconditions: capsOf(mesh) is empty; solid has grid.cellCount()
// entries. Throws Cancelled.
void fillClosed(const geometry::TriangleMesh& mesh, const VoxelGrid& grid,
                std::vector<std::uint8_t>& solid, const base::RunContext& ctx);

// Sets solid[cell] = 1 where the generalised winding number of the open mesh about the cell's
// centre is nearer to another whole number than to 0. It is computed as that of mesh and caps
// together, a whole number from column crossings, minus that of the few caps, which is much cheaper
// than evaluating it for the mesh. Preconditions: caps == capsOf(mesh); solid as above. Throws
// Cancelled.
void fillOpen(const geometry::TriangleMesh& mesh, const geometry::TriangleMesh& caps,
              const VoxelGrid& grid, std::vector<std::uint8_t>& solid, const base::RunContext& ctx);

} // namespace voluta::voxel
