// The voxels that slicing along one direction cannot print.
#pragma once

#include "voxel/solid_voxels.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace voluta::planar {

// Voxels that uniform slicing misses (Boge 6.3). The layers are the grid's, from the plate upwards.
// A voxel is printed if it is on the plate or has a printed AM-stable neighbour in the layer below
// (Boge, definition 3: directly below or diagonally below across an edge).
struct UniformMisses {
  std::size_t count = 0;
  std::vector<std::uint8_t> missed; // per cell of the grid
};
// `isCarried`: of a cell's middle, whether a column would carry it; null: no columns.
UniformMisses uniformMisses(const voxel::SolidVoxels& part,
                            const std::function<bool(const Eigen::Vector3d&)>& isCarried = {});

} // namespace voluta::planar
