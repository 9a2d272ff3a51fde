// Which cells of a column have their centre inside a closed mesh.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "voxel/voxel_grid.h"

#include <cstdint>
#include <vector>

namespace voluta::voxel {

// Whether every directed edge has as many opposite ones, vertices compared by position: then each
// line crosses the mesh with total winding zero.
bool isClosed(const geometry::TriangleMesh& mesh);

// Sets solid[cell] = 1 where the winding number of the mesh about the cell's centre is not zero.
// Crossings of the vertical line through each column are decided edge by edge with the same
// arithmetic for both triangles at an edge, so a line through an edge or a vertex of a closed mesh
// is never counted twice or lost.
// Preconditions: isClosed(mesh); solid has grid.cellCount() entries. Throws Cancelled.
void fillClosed(const geometry::TriangleMesh& mesh, const VoxelGrid& grid,
                std::vector<std::uint8_t>& solid, const base::RunContext& ctx);

} // namespace voluta::voxel
