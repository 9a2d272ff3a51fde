// How much hangs on a single voxel: articulation points of the part's graph.
#pragma once

#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// Keeps what it works in, so that asking again costs only what is left by then.
class CutVoxels {
public:
  // Keeps a reference.
  explicit CutVoxels(const VoxelGraph& graph) : graph_(graph) {}

  // Looks through the voxels with present[v]; `among` holds them all and maybe others. One
  // depth-first search from a root that stands for the platform (Hopcroft and Tarjan 1973).
  void find(const std::vector<std::uint8_t>& present, const std::vector<std::int32_t>& among);

  // How many other present voxels lose every way to the platform when v goes (0 for most).
  // Precondition: v was present and reached.
  std::int32_t lossWithout(std::size_t v) const { return node_[v].loss; }

private:
  struct Node {
    std::int32_t enter = -1, low = 0, size = 1, loss = 0;
  };
  struct Step {
    std::int32_t voxel, parent;
    std::uint32_t next;
  };
  const VoxelGraph& graph_;
  std::vector<Node> node_;
  std::vector<Step> path_;
};

} // namespace voluta::curved
