// Estimates the memory that a voxel width needs, before voxels are made.
#pragma once

#include "geometry/triangle_mesh.h"
#include "voxel/solid_voxels.h"

#include <cstdint>

namespace voluta::voxel {

// Approximate total for growth, field and front; on the high side for many voxels: a solid part of
// 2,000,000 voxels peaks at 0.8 GB.
inline constexpr double kBytesPerCell = 32.0, kBytesPerVoxel = 400.0;

struct VoxelDemand {
  double cells = 0.0, voxels = 0.0; // Of the grid; solid
  double bytes() const { return kBytesPerCell * cells + kBytesPerVoxel * voxels; }
};

// Estimates the result of solidVoxels(mesh, pitch), as used by checkVoxelDemand: the mesh's volume
// and half a voxel on its surface. Preconditions (Error{Internal}): pitch > 0, mesh not empty.
VoxelDemand voxelDemand(const geometry::TriangleMesh& mesh, double pitch);

// Throws Error{Usage}, naming the smallest possible width, if curved mode needs more than
// `availableBytes` at this pitch. Preconditions as above.
void checkVoxelDemand(const geometry::TriangleMesh& mesh, double pitch,
                      std::uint64_t availableBytes);

// The same for existing cells; throws Error{UnusableInput}.
void checkVoxelDemand(const SolidVoxels& voxels, std::uint64_t availableBytes);

} // namespace voluta::voxel
