// How many voxels depend on a single voxel: articulation points of the part's graph.
#pragma once

#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// Keeps its working memory, so that repeated searches only cost the remaining voxels.
class CutVoxels {
public:
  // Keeps a reference.
  explicit CutVoxels(const VoxelGraph& graph) : graph_(graph) {}

  // Searches the voxels with present[v]; `among` contains all of them and possibly others. One
  // depth-first search from a root that represents the platform (Hopcroft and Tarjan 1973).
  void find(const std::vector<std::uint8_t>& present, const std::vector<std::int32_t>& among);

  // Returns how many other present voxels lose all connection to the platform when v is removed (0
  // for most). Precondition: v was present and reached.
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
