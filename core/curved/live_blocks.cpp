#include "curved/live_blocks.h"

#include <Eigen/Geometry>
#include <map>
#include <tuple>

namespace voluta::curved {

LiveBlocks::LiveBlocks(const VoxelGraph& graph) : live_(graph.size(), 1) {
  constexpr int kEdge = 6;
  std::map<std::tuple<int, int, int>, std::vector<std::int32_t>> cells;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const auto& c = graph.cell[v];
    cells[{c[2] / kEdge, c[1] / kEdge, c[0] / kEdge}].push_back(static_cast<std::int32_t>(v));
  }
  for (auto& [at, voxels] : cells) {
    Eigen::AlignedBox3d box;
    for (const std::int32_t v : voxels)
      box.extend(graph.lattice(static_cast<std::size_t>(v)));
    blocks_.push_back({box.center(), 0.5 * box.sizes(), std::move(voxels)});
  }
}

void LiveBlocks::inside(const IncrementalFront& front, std::vector<std::int32_t>& out) {
  out.clear();
  for (Block& block : blocks_) {
    if (block.voxels.empty() || front.boxOutside(block.centre, block.halfSize))
      continue;
    std::size_t kept = 0;
    for (const std::int32_t v : block.voxels) {
      if (!live_[static_cast<std::size_t>(v)])
        continue;
      block.voxels[kept++] = v;
      if (front.inside(v))
        out.push_back(v);
    }
    block.voxels.resize(kept);
  }
}

} // namespace voluta::curved
