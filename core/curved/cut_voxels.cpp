#include "curved/cut_voxels.h"

#include <algorithm>

namespace voluta::curved {

std::vector<std::int32_t> lossWithout(const VoxelGraph& graph,
                                      const std::vector<std::uint8_t>& present) {
  const std::size_t n = graph.size();
  std::vector<std::int32_t> loss(n, 0), enter(n, -1), low(n, 0), size(n, 1);
  struct Step {
    std::int32_t voxel, parent;
    std::uint32_t next;
  };
  std::vector<Step> path;
  std::int32_t time = 1; // 0 is the platform's
  for (std::size_t root = 0; root < n; ++root) {
    if (!present[root] || !graph.onPlatform[root] || enter[root] >= 0)
      continue;
    enter[root] = time++;
    low[root] = 0;
    path.push_back({static_cast<std::int32_t>(root), -1, 0});
    while (!path.empty()) {
      Step& step = path.back();
      const auto v = static_cast<std::size_t>(step.voxel);
      if (step.next < kNeighbours) {
        const std::int32_t w = graph.neighbour[v][step.next++];
        if (w < 0 || w == step.parent || !present[static_cast<std::size_t>(w)])
          continue;
        const auto x = static_cast<std::size_t>(w);
        if (enter[x] >= 0) {
          low[v] = std::min(low[v], enter[x]);
          continue;
        }
        enter[x] = time++;
        low[x] = graph.onPlatform[x] ? 0 : enter[x];
        path.push_back({w, step.voxel, 0});
        continue;
      }
      const std::int32_t parent = step.parent;
      path.pop_back();
      if (parent < 0)
        continue;
      const auto p = static_cast<std::size_t>(parent);
      low[p] = std::min(low[p], low[v]);
      size[p] += size[v];
      if (low[v] >= enter[p])
        loss[p] += size[v];
    }
  }
  return loss;
}

} // namespace voluta::curved
