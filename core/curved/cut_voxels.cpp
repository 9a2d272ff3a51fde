#include "curved/cut_voxels.h"

#include <algorithm>

namespace voluta::curved {

void CutVoxels::find(const std::vector<std::uint8_t>& present,
                     const std::vector<std::int32_t>& among) {
  node_.resize(graph_.size());
  for (const std::int32_t v : among)
    node_[static_cast<std::size_t>(v)] = {};
  std::int32_t time = 1; // 0 is the platform's time
  for (const std::int32_t start : among) {
    const auto root = static_cast<std::size_t>(start);
    if (!present[root] || !graph_.onPlatform[root] || node_[root].enter >= 0)
      continue;
    node_[root].enter = time++;
    path_.push_back({start, -1, 0});
    while (!path_.empty()) {
      Step& step = path_.back();
      Node& node = node_[static_cast<std::size_t>(step.voxel)];
      if (step.next < kNeighbours) {
        const std::int32_t w = graph_.neighbour[static_cast<std::size_t>(step.voxel)][step.next++];
        if (w < 0 || w == step.parent || !present[static_cast<std::size_t>(w)])
          continue;
        Node& other = node_[static_cast<std::size_t>(w)];
        if (other.enter >= 0) {
          node.low = std::min(node.low, other.enter);
          continue;
        }
        other.enter = time++;
        other.low = graph_.onPlatform[static_cast<std::size_t>(w)] ? 0 : other.enter;
        path_.push_back({w, step.voxel, 0});
        continue;
      }
      const std::int32_t parent = step.parent;
      path_.pop_back();
      if (parent < 0)
        continue;
      Node& above = node_[static_cast<std::size_t>(parent)];
      above.low = std::min(above.low, node.low);
      above.size += node.size;
      if (node.low >= above.enter)
        above.loss += node.size;
    }
  }
}

} // namespace voluta::curved
