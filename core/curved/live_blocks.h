// Voxels that are not laid yet, by blocks, so that those which a larger front would shadow are
// found without asking about each.
#pragma once

#include "curved/incremental_front.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

class LiveBlocks {
public:
  // All voxels live.
  explicit LiveBlocks(const VoxelGraph& graph);

  void remove(const std::vector<std::int32_t>& voxels) {
    for (const std::int32_t v : voxels)
      live_[static_cast<std::size_t>(v)] = 0;
  }

  // Live voxels inside the front, in a fixed order.
  void inside(const IncrementalFront& front, std::vector<std::int32_t>& out);

private:
  struct Block {
    Eigen::Vector3d centre, halfSize; // of the box of its centres of voxels, on the lattice
    std::vector<std::int32_t> voxels; // those that were live when it was last looked through
  };

  std::vector<std::uint8_t> live_;
  std::vector<Block> blocks_;
};

} // namespace voluta::curved
