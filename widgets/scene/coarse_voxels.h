// Blocks in place of voxels, for fast frames. Private to the module.
#pragma once

#include "curved/decomposition.h"
#include "voxel/voxel_grid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voluta::scene {

// Cells of a voxel drawing, flat arrays over its grid.
struct ShownCells {
  voxel::VoxelGrid grid;
  std::span<const std::int32_t> rank;    // display order, from 1; -1 missed, 0 outside
  std::span<const std::int32_t> value;   // that gives the colour
  std::span<const std::uint8_t> support; // empty: none
  std::span<const curved::Loss> loss;    // empty: Shadowed
};

// Blocks of factor^3 cells. A block is there if about a third of it is; its rank and value are the
// means of its printed cells, and it is missed if most of its cells are.
class CoarseVoxels {
public:
  // Precondition: factor >= 2.
  CoarseVoxels(const ShownCells& fine, int factor);

  ShownCells cells() const { return {grid_, rank_, value_, support_, loss_}; }

private:
  voxel::VoxelGrid grid_;
  std::vector<std::int32_t> rank_, value_;
  std::vector<std::uint8_t> support_;
  std::vector<curved::Loss> loss_;
};

} // namespace voluta::scene
