// What slicing along one direction cannot print, counted in voxels.
#pragma once

#include "voxel/solid_voxels.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::planar {

// Voxels that uniform slicing misses (Boge 6.3): the layers are the grid's, from the plate upwards;
// a voxel is printed where it stands on the plate or has a printed AM-stable neighbour in the layer
// under it (Boge, definition 3: right below or over the edge from there).
struct UniformMisses {
  std::size_t count = 0;
  std::vector<std::uint8_t> missed; // per cell of the grid
};
UniformMisses uniformMisses(const voxel::SolidVoxels& part);

} // namespace voluta::planar
