// A part given as cells instead of a mesh.
#pragma once

#include "geometry/triangle_mesh.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace voluta::voxel {

// Lengths are in cells; cell (i, j, k) spans [i, i + 1] x [j, j + 1] x [k, k + 1], and the plate is
// z = 0. A flat object is one cell deep in y.
struct VoxelObject {
  Eigen::Vector3i size = Eigen::Vector3i::Zero(); // Cells along x, y, z
  std::vector<std::uint8_t> solid;                // Per cell 1 where the part is; x varies fastest
  std::vector<std::array<int, 2>> platform; // Columns (i, j) of the platform, sorted by j, then i

  std::size_t index(int i, int j, int k) const { return VoxelGrid{.size = size}.index(i, j, k); }
  bool solidAt(int i, int j, int k) const {
    return VoxelGrid{.size = size}.contains(i, j, k) && solid[index(i, j, k)] != 0;
  }
};

// Returns the boundary of the object's cells, two triangles per face, facing outward, lengths in
// cells. A manifold without open edges even where cells touch only by an edge or a corner: such
// cells get separate vertices at the same position. Where two sheets share both ends of an edge,
// each also gets a vertex in the middle of it. Precondition (Error{Internal}): solid has as many
// entries as size states.
geometry::TriangleMesh surfaceOf(const VoxelObject& object);

// Returns the object's cells, rotated, `pitch` mm wide, with an empty border. The box of its solid
// cells is centred over `centreMm`, its lowest layer is `liftCells` above the plate. `rotation`: a
// rotation by quarter turns, entries -1, 0, 1. Preconditions (Error{Internal}): such a rotation,
// pitch > 0, at least one solid cell.
SolidVoxels solidVoxels(const VoxelObject& object, const Eigen::Matrix3i& rotation, double pitch,
                        const Eigen::Vector2d& centreMm, int liftCells);

} // namespace voluta::voxel
