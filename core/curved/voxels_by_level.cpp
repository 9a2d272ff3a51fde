#include "curved/voxels_by_level.h"

#include <algorithm>
#include <numeric>

namespace voluta::curved {

VoxelsByLevel::VoxelsByLevel(const std::vector<std::int32_t>& level) {
  const std::int32_t highest =
      level.empty() ? -1 : std::max(-1, *std::max_element(level.begin(), level.end()));
  // Start of each level, then position of its next voxel (counting sort).
  std::vector<std::size_t> next(static_cast<std::size_t>(highest) + 2, 0);
  for (const std::int32_t l : level)
    if (l >= 0)
      ++next[static_cast<std::size_t>(l) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  voxels_.resize(next.back());
  first_ = next;
  first_.erase(std::unique(first_.begin(), first_.end()), first_.end());
  for (std::size_t v = 0; v < level.size(); ++v)
    if (level[v] >= 0)
      voxels_[next[static_cast<std::size_t>(level[v])]++] = static_cast<std::int32_t>(v);
}

} // namespace voluta::curved
