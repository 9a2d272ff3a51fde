// Voxels not printed yet, in blocks, so that the voxels shadowed by a larger front are found
// without testing each one.
#pragma once

#include "curved/incremental_front.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

class LiveBlocks {
public:
  // Starts with all voxels live.
  explicit LiveBlocks(const VoxelGraph& graph);

  void remove(const std::vector<std::int32_t>& voxels) {
    for (const std::int32_t v : voxels)
      live_[static_cast<std::size_t>(v)] = 0;
  }

  // Appends the live voxels inside the front, in a fixed order.
  void inside(const IncrementalFront& front, std::vector<std::int32_t>& out);

private:
  struct Block {
    Eigen::Vector3d centre, halfSize; // Bounding box of the block's voxel centres, on the lattice
    std::vector<std::int32_t> voxels; // The voxels that were live at the last search
  };

  std::vector<std::uint8_t> live_;
  std::vector<Block> blocks_;
};

} // namespace voluta::curved
